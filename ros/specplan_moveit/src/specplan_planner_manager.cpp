// SPDX-License-Identifier: BSD-3-Clause
// MoveIt's OMPL interface with one more planner: specplan::SpeculativeAStar. See docs/moveit.md.
#if __has_include(<moveit/ompl_interface/ompl_interface.hpp>)
#include <moveit/ompl_interface/ompl_interface.hpp>
#include <moveit/ompl_interface/parameterization/work_space/pose_model_state_space.hpp>
#include <moveit/planning_interface/planning_interface.hpp>
#else  // MoveIt 2 up to Jazzy
#include <moveit/ompl_interface/ompl_interface.h>
#include <moveit/ompl_interface/parameterization/work_space/pose_model_state_space.h>
#include <moveit/planning_interface/planning_interface.h>
#endif

#include <memory>
#include <string>
#include <vector>

#include <ompl/util/Console.h>
#include <specplan/planner/PlannerAllocator.h>
#include <pluginlib/class_list_macros.hpp>
#include <rclcpp/rclcpp.hpp>

namespace specplan_moveit
{
namespace
{
/// Sends what OMPL and its planners say to ROS.
class RosOutput : public ompl::msg::OutputHandler
{
public:
    void log(const std::string& text, ompl::msg::LogLevel level, const char* file, int line) override
    {
        const auto logger = rclcpp::get_logger("ompl");
        if (level == ompl::msg::LOG_ERROR)
            RCLCPP_ERROR(logger, "%s:%i - %s", file, line, text.c_str());
        else if (level == ompl::msg::LOG_WARN)
            RCLCPP_WARN(logger, "%s:%i - %s", file, line, text.c_str());
        else
            RCLCPP_DEBUG(logger, "%s:%i - %s", file, line, text.c_str());
    }
};

/// States of MoveIt's pose parameterization carry poses next to their joint values. The kinematics solver that computes
/// them is one for all threads, and promises nothing about threads.
void preparePoses(specplan::SpeculativeAStar& planner)
{
    using Poses = ompl_interface::PoseModelStateSpace;
    const auto space = std::dynamic_pointer_cast<Poses>(planner.getSpaceInformation()->getStateSpace());
    if (!space)
        return;
    specplan::PlannerSettings settings = planner.getSettings();
    settings.numThreads = 1;
    planner.setSettings(settings);
    planner.setStateCompleter(
        [space](ompl::base::State* state)
        {
            state->as<Poses::StateType>()->setJointsComputed(true);
            state->as<Poses::StateType>()->setPoseComputed(false);
            space->computeStateFK(state);  // marks the state as invalid where there is no pose
        });
}
}  // namespace

/// Plans with OMPL as ompl_interface/OMPLPlanner does; `type: specplan::SpeculativeAStar` names the planner.
class SpecplanPlannerManager : public planning_interface::PlannerManager
{
public:
    SpecplanPlannerManager()
    {
        ompl::msg::useOutputHandler(&output_);
    }

    ~SpecplanPlannerManager() override
    {
        if (ompl::msg::getOutputHandler() == &output_)
            ompl::msg::restorePreviousOutputHandler();
    }

    bool initialize(const moveit::core::RobotModelConstPtr& model, const rclcpp::Node::SharedPtr& node,
                    const std::string& parameter_namespace) override
    {
        interface_ = std::make_unique<ompl_interface::OMPLInterface>(model, node, parameter_namespace);
        interface_->getPlanningContextManager().registerPlannerAllocator(
            "specplan::SpeculativeAStar",
            specplan::PlannerAllocator(std::make_shared<specplan::ThreadBudget>(), preparePoses));
        setPlannerConfigurations(interface_->getPlannerConfigurations());
        return true;
    }

    std::string getDescription() const override
    {
        return "OMPL with specplan";
    }

    void getPlanningAlgorithms(std::vector<std::string>& names) const override
    {
        names.clear();
        for (const auto& config : interface_->getPlannerConfigurations())
            names.push_back(config.first);
    }

    void setPlannerConfigurations(const planning_interface::PlannerConfigurationMap& configurations) override
    {
        interface_->setPlannerConfigurations(configurations);
        PlannerManager::setPlannerConfigurations(interface_->getPlannerConfigurations());  // defaults are among them
    }

    bool canServiceRequest(const planning_interface::MotionPlanRequest& request) const override
    {
        return request.trajectory_constraints.constraints.empty();
    }

    planning_interface::PlanningContextPtr getPlanningContext(const planning_scene::PlanningSceneConstPtr& scene,
                                                              const planning_interface::MotionPlanRequest& request,
                                                              moveit_msgs::msg::MoveItErrorCodes& error) const override
    {
        return interface_->getPlanningContext(scene, request, error);
    }

private:
    RosOutput output_;
    std::unique_ptr<ompl_interface::OMPLInterface> interface_;
};
}  // namespace specplan_moveit

PLUGINLIB_EXPORT_CLASS(specplan_moveit::SpecplanPlannerManager, planning_interface::PlannerManager)
