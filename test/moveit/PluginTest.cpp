// SPDX-License-Identifier: BSD-3-Clause
// The MoveIt plugin over a stand-in for MoveIt: what it registers, and what it makes.
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/util/Console.h>
#include <moveit/ompl_interface/ompl_interface.hpp>
#include <moveit/ompl_interface/parameterization/work_space/pose_model_state_space.hpp>

#include "Group.h"

std::unique_ptr<planning_interface::PlannerManager> makePlugin();

namespace specplan::test
{
namespace
{
class Plugin : public ::testing::Test
{
protected:
    Plugin() : manager(makePlugin())
    {
        ompl_interface::PlanningContextManager::allocators().clear();
        rclcpp::logged().clear();
        EXPECT_TRUE(manager->initialize(std::make_shared<moveit::core::RobotModel>(), std::make_shared<rclcpp::Node>(),
                                        "manipulator"));
    }

    [[nodiscard]] static std::shared_ptr<SpeculativeAStar> plannerOf(Group& group)
    {
        const auto& allocator = ompl_interface::PlanningContextManager::allocators().at("specplan::SpeculativeAStar");
        ompl_interface::ModelBasedPlanningContextSpecification specification;
        specification.config_ = {{"type", "specplan::SpeculativeAStar"}, {"num_threads", "4"}, {"weight", "2.0"}};
        return std::dynamic_pointer_cast<SpeculativeAStar>(
            allocator(group.setup.getSpaceInformation(), "manipulator/SpeculativeAStar", specification));
    }

    std::unique_ptr<planning_interface::PlannerManager> manager;
};

TEST_F(Plugin, RegistersThePlanner)
{
    Group group({{Joint::Kind::Revolute, 2.0}, {Joint::Kind::Continuous}});
    const auto planner = plannerOf(group);
    ASSERT_TRUE(planner);
    EXPECT_EQ(planner->getName(), "manipulator/SpeculativeAStar");
    EXPECT_EQ(planner->getSettings().numThreads, 4U);
    group.setup.setStartAndGoalStates(group.state({-1.0, -1.0}), group.state({1.0, 1.0}));
    group.setup.setPlanner(planner);
    ASSERT_EQ(group.setup.solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(group.path().check());
}

TEST_F(Plugin, CompletesTheStatesOfPosesInOneThread)
{
    auto space = std::make_shared<ompl_interface::PoseModelStateSpace>(true);
    Group group(space);
    ob::ScopedState<> start = group.state({-0.5, 0.8, 0.4});
    ob::ScopedState<> goal = group.state({0.7, 0.8, 0.4});
    space->computePose(start.get());
    space->computePose(goal.get());
    group.setup.setStartAndGoalStates(start, goal);
    const auto planner = plannerOf(group);
    EXPECT_EQ(planner->getSettings().numThreads, 1U);
    group.setup.setPlanner(planner);
    ASSERT_EQ(group.setup.solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(group.path().check());
}

TEST_F(Plugin, HandsOnWhatMoveItAsks)
{
    std::vector<std::string> names{"left over"};
    manager->getPlanningAlgorithms(names);
    EXPECT_EQ(names, (std::vector<std::string>{"default", "manipulator[SpeculativeAStar]"}));
    EXPECT_EQ(manager->getPlannerConfigurations().size(), 2U) << "those that MoveIt adds are among them";
    planning_interface::MotionPlanRequest request;
    EXPECT_TRUE(manager->canServiceRequest(request));
    request.trajectory_constraints.constraints.push_back(1);
    EXPECT_FALSE(manager->canServiceRequest(request));
    moveit_msgs::msg::MoveItErrorCodes error;
    EXPECT_TRUE(manager->getPlanningContext(nullptr, {}, error));
    EXPECT_EQ(error.val, 1);
    EXPECT_FALSE(manager->getDescription().empty());
}

TEST_F(Plugin, SendsWhatIsLoggedToRosUntilItEnds)
{
    OMPL_WARN("a warning");
    OMPL_ERROR("an error");
    ASSERT_EQ(rclcpp::logged().size(), 2U);
    EXPECT_EQ(rclcpp::logged()[0].substr(0, 4), "warn");
    EXPECT_EQ(rclcpp::logged()[1].substr(0, 5), "error");
    manager.reset();
    OMPL_WARN("a warning for standard output");
    EXPECT_EQ(rclcpp::logged().size(), 2U);
}
}  // namespace
}  // namespace specplan::test
