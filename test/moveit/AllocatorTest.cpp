// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <string>

#include <gtest/gtest.h>
#include <ompl/base/ConstrainedSpaceInformation.h>
#include <ompl/base/Constraint.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/constraint/ProjectedStateSpace.h>
#include <ompl/tools/multiplan/ParallelPlan.h>

#include "Group.h"
#include "specplan/planner/PlannerAllocator.h"

namespace specplan::test
{
namespace
{
/// Has what MoveIt's ModelBasedPlanningContextSpecification has, as far as an allocator looks.
struct Specification
{
    std::map<std::string, std::string> config_;
    int somethingElse = 0;
};

using ConfiguredAllocator =
    std::function<ob::PlannerPtr(const ob::SpaceInformationPtr&, const std::string&, const Specification&)>;

Specification rosParameters()
{
    return {{{"type", "specplan::SpeculativeAStar"},
             {"longest_valid_segment_fraction", "0.005"},
             {"range", "0.0"},
             {"num_threads", "3"},
             {"weight", "2.500000"},
             {"anytime", "false"},
             {"spacing", "[0.2, 0.2]"}}};
}

TEST(Allocator, TakesRosParametersAndTheName)
{
    Group group({{Joint::Kind::Revolute, 2.0}, {Joint::Kind::Revolute, 2.0}});
    const ConfiguredAllocator allocator = PlannerAllocator();
    const ob::PlannerPtr made =
        allocator(group.setup.getSpaceInformation(), "manipulator/manipulator[SpeculativeAStar]", rosParameters());
    EXPECT_EQ(made->getName(), "manipulator/manipulator[SpeculativeAStar]");
    const auto planner = std::dynamic_pointer_cast<SpeculativeAStar>(made);
    ASSERT_TRUE(planner);
    const PlannerSettings& settings = planner->getSettings();
    EXPECT_EQ(settings.numThreads, 3U);
    EXPECT_EQ(settings.weight, 2.5);
    EXPECT_FALSE(settings.anytime);
    EXPECT_EQ(settings.spacing, (std::vector<double>{0.2, 0.2}));

    group.setup.setStartAndGoalStates(group.state({-1.0, -1.0}), group.state({1.0, 1.0}));
    group.setup.setPlanner(planner);
    ASSERT_EQ(group.setup.solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(group.setup.getProblemDefinition()->getSolutions().front().plannerName_, made->getName());
}

TEST(Allocator, KeepsItsOwnNameWithoutOneAndDefaultsForWhatIsRefused)
{
    Group group({{Joint::Kind::Revolute, 2.0}});
    Specification specification;
    specification.config_ = {{"weight", "0.5"}, {"num_threads", "many"}, {"lookahead", "7"}};
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    const ob::PlannerPtr made = PlannerAllocator()(group.setup.getSpaceInformation(), "", specification);
    ompl::msg::setLogLevel(ompl::msg::LOG_INFO);
    EXPECT_EQ(made->getName(), "SpeculativeAStar");
    const PlannerSettings& settings = std::static_pointer_cast<SpeculativeAStar>(made)->getSettings();
    EXPECT_EQ(settings.weight, 0.0);
    EXPECT_EQ(settings.numThreads, 0U);
    EXPECT_EQ(settings.lookahead, 7U);
}

TEST(Allocator, PreparesEachPlanner)
{
    Group group({{Joint::Kind::Revolute, 2.0}});
    int prepared = 0;
    const PlannerAllocator allocator(nullptr,
                                     [&](SpeculativeAStar& planner)
                                     {
                                         EXPECT_EQ(planner.getSettings().numThreads, 3U) << "parameters come first";
                                         ++prepared;
                                     });
    for (int i = 0; i < 3; ++i)
        (void)allocator(group.setup.getSpaceInformation(), "one", rosParameters());
    EXPECT_EQ(prepared, 3);
}

/// The unit sphere.
class Sphere : public ob::Constraint
{
public:
    Sphere() : ob::Constraint(3, 1)
    {
    }

    void function(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> out) const override
    {
        out[0] = x.norm() - 1.0;
    }
};

TEST(Allocator, PlannersOverConstrainedSpacesRefuseWithoutAnException)
{
    auto ambient = std::make_shared<ob::RealVectorStateSpace>(3);
    ambient->setBounds(-2.0, 2.0);
    auto space = std::make_shared<ob::ProjectedStateSpace>(ambient, std::make_shared<Sphere>());
    og::SimpleSetup setup(std::make_shared<ob::ConstrainedSpaceInformation>(space));
    setup.setStateValidityChecker([](const ob::State*) { return true; });
    ob::ScopedState<> start(space);
    ob::ScopedState<> goal(space);
    start->as<ob::ConstrainedStateSpace::StateType>()->copy(Eigen::Vector3d(1.0, 0.0, 0.0));
    goal->as<ob::ConstrainedStateSpace::StateType>()->copy(Eigen::Vector3d(0.0, 1.0, 0.0));
    setup.setStartAndGoalStates(start, goal);
    const ob::PlannerAllocator allocator = [](const ob::SpaceInformationPtr& si)
    { return PlannerAllocator()(si, "constrained", Specification()); };
    setup.setPlannerAllocator(allocator);
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    EXPECT_EQ(setup.solve(2.0), ob::PlannerStatus::CRASH);
    const std::string error = std::static_pointer_cast<SpeculativeAStar>(setup.getPlanner())->getReport().error;
    EXPECT_NE(error.find("constrained to a manifold"), std::string::npos) << error;
    EXPECT_THROW(setup.getPlanner()->checkValidity(), ompl::Exception) << "whoever asks is told";

    // A thread of ParallelPlan that met an exception would end the program.
    ompl::tools::ParallelPlan attempts(setup.getProblemDefinition());
    attempts.addPlannerAllocator(allocator);
    attempts.addPlannerAllocator(allocator);
    EXPECT_FALSE(attempts.solve(2.0, 1, 2, true));
    ompl::msg::setLogLevel(ompl::msg::LOG_INFO);
}
}  // namespace
}  // namespace specplan::test
