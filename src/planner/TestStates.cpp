// SPDX-License-Identifier: BSD-3-Clause
#include "TestStates.h"

#include <algorithm>
#include <random>
#include <sstream>
#include <utility>

#include <ompl/util/Exception.h>

#include "specplan/lattice/Lattice.h"
#include "specplan/planner/Embedding.h"

namespace specplan::planner
{
namespace ob = ompl::base;

namespace
{
constexpr std::size_t kWalk = 16;       // states of a walk on the lattice
constexpr unsigned kAttempts = 1000;    // samples outside of the bounds in a row
constexpr std::size_t kMostValues = 8;  // of a state in a message

/// Samples inside the bounds.
class UniformStates
{
public:
    explicit UniformStates(const ob::SpaceInformation& si) : si_(si), sampler_(si.allocStateSampler())
    {
    }

    StateHandle next()
    {
        StateHandle state(si_);
        for (unsigned attempt = 0; attempt < kAttempts; ++attempt)
        {
            sampler_->sampleUniform(state.get());
            if (si_.satisfiesBounds(state.get()))
                return state;
        }
        throw ompl::Exception("testChecker: no sample lies inside the bounds of the state space");
    }

private:
    const ob::SpaceInformation& si_;
    ob::StateSamplerPtr sampler_;
};

/// Appends lattice states until there are `count`, or none can be reached.
void appendLatticeStates(const ob::SpaceInformation& si, UniformStates& uniform, std::size_t count, std::uint32_t seed,
                         std::vector<StateHandle>& states)
{
    const Embedding embedding(si, PlannerSettings(), SpaceHooks(), states.front().get());
    lattice::Lattice lattice(embedding.neighbourhood(true));
    std::mt19937 random(seed);
    std::vector<lattice::NodeId> ends;
    for (std::size_t walk = 0; walk < count && states.size() < count; ++walk)
    {
        const auto corners = embedding.corners(uniform.next().get(), Component::Joint::Leaving);
        if (corners.empty())
            continue;
        lattice::NodeId node = lattice.node(corners.front().data());
        for (std::size_t step = 0; step < kWalk && states.size() < count; ++step)
        {
            StateHandle state(si);
            embedding.write(lattice, node, state.get());
            if (si.satisfiesBounds(state.get()))
                states.push_back(std::move(state));
            lattice.neighbours(node, ends);
            if (ends.empty())
                break;
            node = ends[random() % ends.size()];
        }
    }
}
}  // namespace

std::vector<StateHandle> makeTestStates(const ob::SpaceInformation& si, std::size_t count, std::uint32_t seed)
{
    UniformStates uniform(si);
    std::vector<StateHandle> states;
    while (states.size() < (count + 1) / 2)
        states.push_back(uniform.next());
    try
    {
        appendLatticeStates(si, uniform, count, seed, states);
    }
    catch (const ompl::Exception&)
    {
        // The space has no lattice; sampled states have to do.
    }
    while (states.size() < count)
        states.push_back(uniform.next());
    return states;
}

std::string describeState(const ob::SpaceInformation& si, const ob::State* state)
{
    std::vector<double> reals;
    si.getStateSpace()->copyToReals(reals, state);
    std::ostringstream out;
    if (reals.empty())
    {
        si.printState(state, out);
        std::string text = out.str();
        std::ranges::replace(text, '\n', ' ');
        return text;
    }
    for (std::size_t i = 0; i < std::min(reals.size(), kMostValues); ++i)
        out << (i == 0 ? "(" : ", ") << reals[i];
    out << (reals.size() > kMostValues ? ", ...)" : ")");
    return out.str();
}
}  // namespace specplan::planner
