// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/planner/spaces/Components.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include <ompl/base/spaces/DiscreteStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/base/spaces/SO3StateSpace.h>
#include <ompl/base/spaces/TimeStateSpace.h>
#include <ompl/util/Exception.h>

#include "DescribedAxes.h"
#include "RoundingSlack.h"
#include "specplan/planner/spaces/AxesComponent.h"
#include "specplan/planner/spaces/CarComponent.h"
#include "specplan/planner/spaces/CarPrimitives.h"
#include "specplan/planner/spaces/RotationComponent.h"
#include "specplan/planner/spaces/ValueAxes.h"

namespace specplan::planner
{
namespace ob = ompl::base;

namespace
{
constexpr double kAutomaticNodes = 60000.0;
/// A diagonal step is then just shorter than OMPL's default validity resolution, one percent of the extent.
constexpr double kMostCells = 101.0;
constexpr double kAngleCells = 16.0;
constexpr double kRotations = 40.0;
/// The fewest cells across a narrow place.
constexpr double kFewestAcross = 4.0;
constexpr double kUnboundedSteps = 1 << 20;
constexpr unsigned kFewestLevels = 3;
constexpr unsigned kMostLevels = 8;

/// A part of the space before its lattice is chosen.
struct Draft
{
    const Part* part;
    std::vector<RealAxis> axes;  ///< empty for rotations and cars; spacing not chosen yet
    AxesComponent::Access access;
    bool angle = false;     ///< one axis, wrapping
    bool rotation = false;  ///< SO3
    bool car = false;
    double extent = 0.0;   ///< of a car's plane, the smaller one
    double spacing = 0.0;  ///< asked for a rotation or a car's places; 0 if none was
};

/// Beyond this distances, which are squared, have no finite value.
constexpr double kFarthestBound = 1e150;

void requireBounds(const std::string& axis, double low, double high)
{
    if (std::abs(low) <= kFarthestBound && std::abs(high) <= kFarthestBound)
        return;
    std::ostringstream message;
    message << "the bounds of " << axis << " are " << low << " and " << high << "; a lattice needs finite ones, up to "
            << kFarthestBound;
    throw ompl::Exception(message.str());
}

void draftRealVector(const ob::RealVectorStateSpace& space, const std::string& name, Draft& draft)
{
    const ob::RealVectorBounds& bounds = space.getBounds();
    const std::size_t n = space.getDimension();
    for (std::size_t i = 0; i < n; ++i)
    {
        std::string axis = space.getDimensionName(static_cast<unsigned>(i));
        if (axis.empty())
            axis = "axis " + std::to_string(i);
        requireBounds(name + axis, bounds.low[i], bounds.high[i]);
        draft.axes.push_back({name + axis, bounds.low[i], bounds.high[i], false, 0.0, 0.0, false});
    }
    draft.access.read = [n](const ob::State* state, double* values)
    { std::copy_n(state->as<ob::RealVectorStateSpace::StateType>()->values, n, values); };
    draft.access.write = [n](const double* values, ob::State* state)
    { std::copy_n(values, n, state->as<ob::RealVectorStateSpace::StateType>()->values); };
}

void draftAngle(const std::string& name, Draft& draft)
{
    draft.angle = true;
    draft.axes.push_back({name, -std::numbers::pi, std::numbers::pi, true, 0.0, 0.0, false});
    draft.access.read = [](const ob::State* state, double* values)
    { *values = state->as<ob::SO2StateSpace::StateType>()->value; };
    draft.access.write = [](const double* values, ob::State* state)
    { state->as<ob::SO2StateSpace::StateType>()->value = *values; };
}

void draftTime(const ob::TimeStateSpace& space, const std::string& name, Draft& draft)
{
    const double infinity = std::numeric_limits<double>::infinity();
    draft.axes.push_back({name, space.isBounded() ? space.getMinTimeBound() : -infinity,
                          space.isBounded() ? space.getMaxTimeBound() : infinity, false, 0.0, 0.0, false});
    draft.access.read = [](const ob::State* state, double* values)
    { *values = state->as<ob::TimeStateSpace::StateType>()->position; };
    draft.access.write = [](const double* values, ob::State* state)
    { state->as<ob::TimeStateSpace::StateType>()->position = *values; };
}

void draftDiscrete(const ob::DiscreteStateSpace& space, const std::string& name, Draft& draft)
{
    draft.axes.push_back({name, static_cast<double>(space.getLowerBound()), static_cast<double>(space.getUpperBound()),
                          false, 0.0, 1.0, true});
    draft.access.read = [](const ob::State* state, double* values)
    { *values = state->as<ob::DiscreteStateSpace::StateType>()->value; };
    draft.access.write = [](const double* values, ob::State* state)
    { state->as<ob::DiscreteStateSpace::StateType>()->value = static_cast<int>(std::lround(*values)); };
}

Draft makeDraft(const Part& part, const ob::State* origin)
{
    Draft draft{&part, {}, {}};
    const ob::StateSpace* space = part.space.get();
    const std::string name = part.path.empty() ? std::string() : space->getName();
    const std::string prefix = name.empty() ? name : name + ' ';
    if (part.axes != nullptr)
        draftDescribed(part.space, *part.axes, origin, draft.axes, draft.access);
    else if (isCar(*space))
    {
        draft.car = true;
        const ob::RealVectorBounds& bounds = space->as<ob::SE2StateSpace>()->getBounds();
        bounds.check();
        draft.extent = std::min(bounds.high[0] - bounds.low[0], bounds.high[1] - bounds.low[1]);
    }
    else if (const auto* real = dynamic_cast<const ob::RealVectorStateSpace*>(space))
        draftRealVector(*real, prefix, draft);
    else if (dynamic_cast<const ob::SO2StateSpace*>(space) != nullptr)
        draftAngle(prefix + "angle", draft);
    else if (dynamic_cast<const ob::SO3StateSpace*>(space) != nullptr)
        draft.rotation = true;
    else if (const auto* time = dynamic_cast<const ob::TimeStateSpace*>(space))
        draftTime(*time, prefix + "time", draft);
    else if (const auto* discrete = dynamic_cast<const ob::DiscreteStateSpace*>(space))
        draftDiscrete(*discrete, prefix + "value", draft);
    else
        draftValues(part.space, origin, draft.axes, draft.access);
    return draft;
}

unsigned axesOf(const Draft& draft)
{
    return draft.rotation || draft.car ? 3 : static_cast<unsigned>(draft.axes.size());
}

double extentOf(const RealAxis& axis)
{
    const double extent = axis.upper - axis.lower;
    return std::isfinite(extent) ? extent : 1.0;
}

/// The fewest cells along an axis: where there are many axes the first lattice is coarse, and refined if need be.
double fewestCells(double axes)
{
    if (axes <= kFewAxes)
        return 20.0;
    return axes < 8.0 ? 12.0 : 8.0;
}

/// Cells along an axis that is neither an angle nor a rotation, where no resolution was asked for.
double automaticCells(const std::vector<Draft>& drafts)
{
    double angles = 0.0;
    double rotations = 0.0;
    double others = 0.0;
    for (const Draft& draft : drafts)
    {
        angles += draft.angle ? 1.0 : 0.0;
        rotations += draft.rotation ? 1.0 : 0.0;
        for (const RealAxis& axis : draft.axes)
            others += !draft.angle && !axis.whole && axis.lower < axis.upper ? 1.0 : 0.0;
    }
    if (others == 0.0)
        return std::clamp(std::pow(kAutomaticNodes, 1.0 / std::max(angles, 1.0)), fewestCells(angles), kMostCells);
    const double nodes = kAutomaticNodes / (std::pow(kAngleCells, angles) * std::pow(kRotations, rotations));
    return std::clamp(std::floor(std::pow(std::max(nodes, 1.0), 1.0 / others)), fewestCells(others), kMostCells);
}

/// Spacing of a place, the same along all axes but those that would be left with too few cells: as many cells in all as
/// `cells` along each axis.
double evenSpacing(const std::vector<RealAxis>& axes, double cells)
{
    std::vector<double> extents;
    for (const RealAxis& axis : axes)
        if (axis.lower < axis.upper)
            extents.push_back(extentOf(axis));
    std::ranges::sort(extents, std::greater<>());
    double logCells = std::log(cells) * static_cast<double>(extents.size());
    double spacing = 1.0;
    for (; !extents.empty(); extents.pop_back())
    {
        double logVolume = 0.0;
        for (const double extent : extents)
            logVolume += std::log(extent);
        spacing = std::exp((logVolume - logCells) / static_cast<double>(extents.size()));
        if (extents.back() >= kFewestAcross * spacing)
            break;
        logCells -= std::log(kFewestAcross);
    }
    return spacing;
}

/// Where an axis wraps around, twice its spacing has to go round too.
double evenNumber(double cells)
{
    return 2.0 * std::floor(cells / 2.0);
}

bool allAngles(const std::vector<Draft>& drafts)
{
    return std::ranges::all_of(drafts, &Draft::angle);
}

/// Spacings of rotations and cars, and the spacing of each axis where there is one for each of them: one value for
/// all, one for each axis, or one for each axis, rotation and car in the order of the parts.
std::vector<double> takeSpacings(std::vector<Draft>& drafts, const std::vector<double>& values)
{
    std::string names;
    std::size_t axes = 0;
    std::size_t others = 0;
    for (const Draft& draft : drafts)
    {
        for (const RealAxis& axis : draft.axes)
            names += (names.empty() ? "" : ", ") + axis.name;
        axes += draft.axes.size();
        if (!draft.rotation && !draft.car)
            continue;
        ++others;
        names += (names.empty() ? "" : ", ") + draft.part->space->getName() +
                 (draft.rotation ? " (rotation)" : " (places of a car)");
    }
    const bool forAll = values.size() == axes + others;
    if (values.size() > 1 && values.size() != axes && !forAll)
        throw ompl::Exception("spacing has " + std::to_string(values.size()) + " values; give one, or " +
                              (axes > 0 && others > 0 ? std::to_string(axes) + " for the axes, or " : "") +
                              std::to_string(axes + others) + " for: " + names);
    std::vector<double> ofAxes;
    std::size_t next = 0;
    for (Draft& draft : drafts)
    {
        for (std::size_t i = 0; i < draft.axes.size() && values.size() > 1; ++i)
            ofAxes.push_back(values[next++]);
        if (draft.rotation || draft.car)
            draft.spacing = forAll && !values.empty() ? values[next++] : 0.0;
        if (draft.car && values.size() == 1)
            draft.spacing = values.front();
    }
    return ofAxes;
}

void chooseSpacings(std::vector<Draft>& drafts, const PlannerSettings& settings)
{
    const std::vector<double> ofAxes = takeSpacings(drafts, settings.spacing);
    const double cells = automaticCells(drafts);
    const bool onlyAngles = allAngles(drafts);
    std::size_t number = 0;
    for (Draft& draft : drafts)
    {
        const double even = draft.part->place ? evenSpacing(draft.axes, cells) : 0.0;
        for (RealAxis& axis : draft.axes)
        {
            const double extent = extentOf(axis);
            const std::size_t i = number++;
            if (axis.whole)
                continue;
            if (!ofAxes.empty())
                axis.spacing = ofAxes[i];
            else if (!settings.spacing.empty() && (!draft.angle || onlyAngles))
                axis.spacing = settings.spacing.front();
            else if (settings.resolution > 0.0)
                axis.spacing = extent * settings.resolution;
            else if (draft.part->place)
                axis.spacing = std::min(even, extent / kFewestAcross);
            else
                axis.spacing = extent / (draft.angle && !onlyAngles ? kAngleCells
                                         : axis.wraps               ? evenNumber(cells)
                                                                    : cells);
            if (!(axis.spacing > 0.0))
                axis.spacing = 1.0;  // the axis stands still
        }
    }
}

/// Spacing of a car's places: the arc from one heading to the next, unless the plane is too small or large.
double carSpacing(const Draft& draft, const PlannerSettings& settings)
{
    if (draft.spacing > 0.0)
        return draft.spacing;
    if (settings.resolution > 0.0)
        return draft.extent * settings.resolution;
    const double arc = turningRadius(*draft.part->space) * 2.0 * std::numbers::pi / CarComponent::kHeadings;
    return std::clamp(arc, draft.extent / 200.0, draft.extent / 20.0);
}

/// Steps to a quarter turn.
lattice::Coordinate rotationCells(const Draft& draft, const PlannerSettings& settings, bool alone)
{
    const double spacing = draft.spacing > 0.0 ? draft.spacing : settings.resolution * std::numbers::pi;
    if (spacing > 0.0)
        return static_cast<lattice::Coordinate>(
            std::clamp(std::ceil(std::numbers::pi / 2.0 / spacing - kRoundingSlack), 1.0, 4096.0));
    return alone ? 4 : 1;
}

/// Whether a part has a spacing that may be doubled. Where there are many axes angles have few values as it is.
bool mayBeCoarse(const Draft& draft, unsigned axes)
{
    return !std::ranges::all_of(draft.axes, &RealAxis::whole) && (!draft.angle || axes <= kFewAxes);
}

/// How often the lattice may be refined: until its steps are as short as motions that need no check.
unsigned levelsOf(const std::vector<Draft>& drafts, const PlannerSettings& settings)
{
    if (settings.resolution > 0.0 || !settings.spacing.empty())
        return 0;
    double coarsest = 1.0;
    for (const Draft& draft : drafts)
    {
        const double longest = draft.part->space->getLongestValidSegmentLength();
        for (const RealAxis& axis : draft.axes)
            if (!axis.whole && longest > 0.0)
                coarsest = std::max(coarsest, axis.spacing / longest);
    }
    return std::clamp(static_cast<unsigned>(std::ceil(std::log2(coarsest))), kFewestLevels, kMostLevels);
}

unsigned chooseConnectivity(unsigned wanted, unsigned axes, bool beside, bool rotation)
{
    if (wanted != 0)
        return wanted;
    if (rotation)
        return beside ? 1 : 3;
    if (axes <= 3)
        return axes;
    return axes <= 8 ? 2 : 1;
}

std::unique_ptr<Component> makeComponent(Draft& draft, const PlannerSettings& settings, const ob::State* origin,
                                         const LatticeOptions& options, bool alone)
{
    const ob::State* there = draft.part->of(origin);
    const std::string name = draft.part->space->getName();
    if (draft.car)
        return std::make_unique<CarComponent>(draft.part->space, name, carSpacing(draft, settings), there, options);
    if (draft.rotation)
        return std::make_unique<RotationComponent>(name, rotationCells(draft, settings, alone), there, options);
    std::vector<double> values(draft.axes.size());
    draft.access.read(there, values.data());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        RealAxis& axis = draft.axes[i];
        axis.origin = values[i];
        if (!std::isfinite(axis.lower))
            axis.lower = axis.origin - kUnboundedSteps * axis.spacing;
        if (!std::isfinite(axis.upper))
            axis.upper = axis.origin + kUnboundedSteps * axis.spacing;
    }
    return std::make_unique<AxesComponent>(std::move(draft.axes), draft.access, options);
}
}  // namespace

Components makeComponents(const Decomposition& decomposition, const PlannerSettings& settings, const ob::State* origin,
                          bool coarse)
{
    std::vector<Draft> drafts;
    Components components;
    for (const Part& part : decomposition.parts)
    {
        drafts.push_back(makeDraft(part, part.of(origin)));
        components.axes += axesOf(drafts.back());
    }
    if (settings.connectivity > components.axes)
        throw ompl::Exception("connectivity is " + std::to_string(settings.connectivity) + "; the space has only " +
                              std::to_string(components.axes) + " axes");
    chooseSpacings(drafts, settings);
    const bool alone = drafts.size() == 1;
    const unsigned levels = levelsOf(drafts, settings);
    coarse = coarse && settings.resolution == 0.0 && settings.spacing.empty();
    for (Draft& draft : drafts)
    {
        components.begunCoarse.push_back(coarse && mayBeCoarse(draft, components.axes));
        if (components.begunCoarse.back())
            for (RealAxis& axis : draft.axes)
                axis.spacing *= axis.whole ? 1.0 : 2.0;
        const ob::StateSpace& space = *draft.part->space;
        LatticeOptions options{};
        options.weight = draft.part->weight;
        options.longest = decomposition.sumsDistances
                              ? space.getLongestValidSegmentLength() / space.getValidSegmentCountFactor()
                              : -1.0;
        options.levels = levels + (components.begunCoarse.back() ? 1 : 0);
        options.connectivity = chooseConnectivity(settings.connectivity, axesOf(draft), !alone, draft.rotation);
        components.all.push_back(makeComponent(draft, settings, origin, options, alone));
    }
    components.connectivity =
        settings.connectivity != 0 ? settings.connectivity : (components.axes <= 3 ? components.axes : 0);
    return components;
}
}  // namespace specplan::planner
