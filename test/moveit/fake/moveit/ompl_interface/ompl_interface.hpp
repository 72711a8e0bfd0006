// SPDX-License-Identifier: BSD-3-Clause
// As much of MoveIt's OMPL interface as the plugin names; names and signatures are MoveIt's.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include <ompl/base/Planner.h>
#include <moveit/planning_interface/planning_interface.hpp>

namespace ompl_interface
{
struct ModelBasedPlanningContextSpecification
{
    std::map<std::string, std::string> config_;
};

using ConfiguredPlannerAllocator =
    std::function<ompl::base::PlannerPtr(const ompl::base::SpaceInformationPtr& si, const std::string& name,
                                         const ModelBasedPlanningContextSpecification& spec)>;

class PlanningContextManager
{
public:
    void registerPlannerAllocator(const std::string& planner_id, const ConfiguredPlannerAllocator& pa)
    {
        allocators()[planner_id] = pa;
    }

    /// For tests: of the manager made last.
    static std::map<std::string, ConfiguredPlannerAllocator>& allocators()
    {
        static std::map<std::string, ConfiguredPlannerAllocator> known;
        return known;
    }
};

class OMPLInterface
{
public:
    OMPLInterface(const moveit::core::RobotModelConstPtr&, const rclcpp::Node::SharedPtr&, const std::string& name)
    {
        configurations_[name + "[SpeculativeAStar]"] = {name, name + "[SpeculativeAStar]", {}};
    }

    PlanningContextManager& getPlanningContextManager()
    {
        return manager_;
    }

    void setPlannerConfigurations(const planning_interface::PlannerConfigurationMap& pconfig)
    {
        configurations_ = pconfig;
        configurations_["default"] = {};
    }

    const planning_interface::PlannerConfigurationMap& getPlannerConfigurations() const
    {
        return configurations_;
    }

    std::shared_ptr<planning_interface::PlanningContext> getPlanningContext(
        const planning_scene::PlanningSceneConstPtr&, const planning_interface::MotionPlanRequest&,
        moveit_msgs::msg::MoveItErrorCodes& error_code) const
    {
        error_code.val = 1;
        return std::make_shared<planning_interface::PlanningContext>();
    }

private:
    PlanningContextManager manager_;
    planning_interface::PlannerConfigurationMap configurations_;
};
}  // namespace ompl_interface
