// SPDX-License-Identifier: BSD-3-Clause
// What the planner tells the user, word for word.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/util/Console.h>

#include "Scene.h"

namespace specplan::test
{
namespace
{
/// Keeps what OMPL is told to print.
class Listener : public ompl::msg::OutputHandler
{
public:
    Listener()
    {
        ompl::msg::useOutputHandler(this);
    }

    ~Listener() override
    {
        ompl::msg::restorePreviousOutputHandler();
    }

    void log(const std::string& line, ompl::msg::LogLevel, const char*, int) override
    {
        text += line + '\n';
    }

    std::string text;
};

#define EXPECT_SAYS(text, words) EXPECT_NE((text).find(words), std::string::npos) << (text)

TEST(Message, NoPathOnTheLattice)
{
    Scene scene;
    scene.closed = true;
    PlannerSettings settings = settingsFor(1);
    settings.anytime = false;
    scene.plan(settings);
    Listener listener;
    (void)scene.solve();
    EXPECT_SAYS(listener.text, "no goal can be reached on this lattice");
}

TEST(Message, InvalidStart)
{
    Scene scene;
    scene.start = {{0.5, 0.5}};
    scene.plan(settingsFor(1));
    Listener listener;
    (void)scene.solve();
    EXPECT_EQ(scene.planner->getReport().status, "invalid start");
    EXPECT_SAYS(listener.text, "there is no valid start state");
}

TEST(Message, AllocatorsThatReturnNothing)
{
    Scene scene;
    scene.plan(settingsFor(1));
    scene.planner->setStateValidityCheckerAllocator([](const ob::SpaceInformationPtr&, unsigned)
                                                    { return ob::StateValidityCheckerPtr(); });
    EXPECT_EQ(scene.solve(), ob::PlannerStatus::CRASH);
    EXPECT_EQ(scene.planner->getReport().error, "the state validity checker allocator returned nothing");
    scene.planner->setStateValidityCheckerAllocator({});
    scene.planner->setMotionValidatorAllocator([](const ob::SpaceInformationPtr&, unsigned)
                                               { return ob::MotionValidatorPtr(); });
    EXPECT_EQ(scene.solve(), ob::PlannerStatus::CRASH);
    EXPECT_EQ(scene.planner->getReport().error, "the motion validator allocator returned nothing");
}

TEST(Message, TooManyCells)
{
    Scene scene;
    PlannerSettings settings = settingsFor(1);
    settings.spacing = {1e-12};
    Listener listener;
    scene.plan(settings);
    EXPECT_EQ(scene.solve(), ob::PlannerStatus::CRASH);
    EXPECT_SAYS(scene.planner->getReport().error, "the lattice has more than 2^30 cells along");
    EXPECT_SAYS(listener.text, "solve() will fail: ");
}

class NaNObjective : public ob::OptimizationObjective
{
public:
    using ob::OptimizationObjective::OptimizationObjective;

    ob::Cost stateCost(const ob::State*) const override
    {
        return ob::Cost(1.0);
    }

    ob::Cost motionCost(const ob::State*, const ob::State*) const override
    {
        return ob::Cost(std::numeric_limits<double>::quiet_NaN());
    }
};

TEST(Message, ACostThatIsNoNumber)
{
    Scene scene;
    scene.setup.setOptimizationObjective(std::make_shared<NaNObjective>(scene.setup.getSpaceInformation()));
    scene.plan(settingsFor(1));
    EXPECT_EQ(scene.solve(), ob::PlannerStatus::CRASH);
    EXPECT_SAYS(scene.planner->getReport().error, "has a motion whose cost is NaN");
}
}  // namespace
}  // namespace specplan::test
