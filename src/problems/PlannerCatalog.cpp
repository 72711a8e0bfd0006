// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/PlannerCatalog.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <exception>
#include <string_view>

#include <ompl/geometric/planners/AnytimePathShortening.h>
#include <ompl/geometric/planners/cforest/CForest.h>
#include <ompl/geometric/planners/est/BiEST.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/est/ProjEST.h>
#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/AITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/kpiece/BKPIECE1.h>
#include <ompl/geometric/planners/kpiece/KPIECE1.h>
#include <ompl/geometric/planners/kpiece/LBKPIECE1.h>
#include <ompl/geometric/planners/pdst/PDST.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/prm/LazyPRMstar.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/prm/SPARS.h>
#include <ompl/geometric/planners/prm/SPARStwo.h>
#include <ompl/geometric/planners/rlrt/BiRLRT.h>
#include <ompl/geometric/planners/rlrt/RLRT.h>
#include <ompl/geometric/planners/rrt/BiTRRT.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/LBTRRT.h>
#include <ompl/geometric/planners/rrt/LazyLBTRRT.h>
#include <ompl/geometric/planners/rrt/LazyRRT.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTXstatic.h>
#include <ompl/geometric/planners/rrt/RRTsharp.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/geometric/planners/rrt/SORRTstar.h>
#include <ompl/geometric/planners/rrt/TRRT.h>
#include <ompl/geometric/planners/rrt/pRRT.h>
#include <ompl/geometric/planners/sbl/SBL.h>
#include <ompl/geometric/planners/sbl/pSBL.h>
#include <ompl/geometric/planners/sst/SST.h>
#include <ompl/geometric/planners/stride/STRIDE.h>

#include <ompl/util/Console.h>

#include "specplan/planner/SpeculativeAStar.h"
#include "specplan/problems/InputError.h"

namespace specplan::problems
{
namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{
struct CatalogEntry
{
    std::string_view name;
    std::string_view alias;  ///< OMPL.app's name where it is another; empty otherwise
    ob::PlannerPtr (*make)(const ob::SpaceInformationPtr& si);
};

template <typename Planner>
ob::PlannerPtr make(const ob::SpaceInformationPtr& si)
{
    return std::make_shared<Planner>(si);
}

/// BIT* and ABIT* connect to the k nearest by default, and OMPL before 1.6 warns that their names say otherwise.
template <typename Planner>
ob::PlannerPtr makeNearest(const ob::SpaceInformationPtr& si)
{
    ob::PlannerPtr planner = std::make_shared<Planner>(si);
    if (!planner->getName().starts_with('k'))
        planner->setName('k' + planner->getName());
    return planner;
}

constexpr std::array kCatalog{
    CatalogEntry{"SpeculativeAStar", "", &make<SpeculativeAStar>},
    CatalogEntry{"ABITstar", "", &makeNearest<og::ABITstar>},
    CatalogEntry{"AITstar", "", &make<og::AITstar>},
    CatalogEntry{"AnytimePathShortening", "aps", &make<og::AnytimePathShortening>},
    CatalogEntry{"BFMT", "", &make<og::BFMT>},
    CatalogEntry{"BITstar", "", &makeNearest<og::BITstar>},
    CatalogEntry{"BKPIECE1", "bkpiece", &make<og::BKPIECE1>},
    CatalogEntry{"BiEST", "", &make<og::BiEST>},
    CatalogEntry{"BiRLRT", "", &make<og::BiRLRT>},
    CatalogEntry{"BiTRRT", "", &make<og::BiTRRT>},
    CatalogEntry{"CForest", "", &make<og::CForest>},
    CatalogEntry{"EST", "", &make<og::EST>},
    CatalogEntry{"FMT", "", &make<og::FMT>},
    CatalogEntry{"InformedRRTstar", "", &make<og::InformedRRTstar>},
    CatalogEntry{"KPIECE1", "kpiece", &make<og::KPIECE1>},
    CatalogEntry{"LBKPIECE1", "lbkpiece", &make<og::LBKPIECE1>},
    CatalogEntry{"LBTRRT", "", &make<og::LBTRRT>},
    CatalogEntry{"LazyLBTRRT", "", &make<og::LazyLBTRRT>},
    CatalogEntry{"LazyPRM", "", &make<og::LazyPRM>},
    CatalogEntry{"LazyPRMstar", "", &make<og::LazyPRMstar>},
    CatalogEntry{"LazyRRT", "", &make<og::LazyRRT>},
    CatalogEntry{"PDST", "", &make<og::PDST>},
    CatalogEntry{"PRM", "", &make<og::PRM>},
    CatalogEntry{"PRMstar", "", &make<og::PRMstar>},
    CatalogEntry{"ProjEST", "", &make<og::ProjEST>},
    CatalogEntry{"RLRT", "", &make<og::RLRT>},
    CatalogEntry{"RRT", "", &make<og::RRT>},
    CatalogEntry{"RRTConnect", "", &make<og::RRTConnect>},
    CatalogEntry{"RRTXstatic", "", &make<og::RRTXstatic>},
    CatalogEntry{"RRTsharp", "", &make<og::RRTsharp>},
    CatalogEntry{"RRTstar", "", &make<og::RRTstar>},
    CatalogEntry{"SBL", "", &make<og::SBL>},
    CatalogEntry{"SORRTstar", "", &make<og::SORRTstar>},
    CatalogEntry{"SPARS", "", &make<og::SPARS>},
    CatalogEntry{"SPARStwo", "spars2", &make<og::SPARStwo>},
    CatalogEntry{"SST", "", &make<og::SST>},
    CatalogEntry{"STRIDE", "", &make<og::STRIDE>},
    CatalogEntry{"TRRT", "", &make<og::TRRT>},
    CatalogEntry{"pRRT", "", &make<og::pRRT>},
    CatalogEntry{"pSBL", "", &make<og::pSBL>},
};

bool equalIgnoringCase(std::string_view a, std::string_view b)
{
    return std::ranges::equal(a, b,
                              [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

const CatalogEntry* find(const std::string& name)
{
    const auto found = std::ranges::find_if(
        kCatalog, [&name](const CatalogEntry& entry)
        { return equalIgnoringCase(entry.name, name) || (!name.empty() && equalIgnoringCase(entry.alias, name)); });
    return found == kCatalog.end() ? nullptr : &*found;
}

/// Silences OMPL, which prints a warning of its own where a parameter is refused.
class QuietOmpl
{
public:
    QuietOmpl()
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    }

    ~QuietOmpl()
    {
        ompl::msg::setLogLevel(level_);
    }

    QuietOmpl(const QuietOmpl&) = delete;
    QuietOmpl& operator=(const QuietOmpl&) = delete;

private:
    ompl::msg::LogLevel level_ = ompl::msg::getLogLevel();
};

void setParameter(ob::Planner& planner, const std::string& name, const std::string& key, const std::string& value)
{
    if (!planner.params().hasParam(key))
        throw InputError(concat("planner ", name, ": expected one of its parameters, found ", inQuotes(key)));
    bool accepted = false;
    try
    {
        const QuietOmpl quiet;
        accepted = planner.params().setParam(key, value);
    }
    catch (const std::exception&)
    {
        accepted = false;
    }
    const std::string& range = planner.params()[key].getRangeSuggestion();
    if (!accepted)
        throw InputError(concat("planner ", name, ": ", key, " cannot be ", inQuotes(value),
                                range.empty() ? "" : concat(", expected ", range)));
}
}  // namespace

std::vector<std::string> plannerNames()
{
    std::vector<std::string> names;
    names.reserve(kCatalog.size());
    for (const CatalogEntry& entry : kCatalog)
        names.emplace_back(entry.name);
    return names;
}

bool isPlannerName(const std::string& name)
{
    return find(name) != nullptr;
}

ob::PlannerPtr makePlanner(const std::string& name, const std::map<std::string, std::string>& parameters,
                           const ob::SpaceInformationPtr& si)
{
    const CatalogEntry* entry = find(name);
    if (entry == nullptr)
        throw InputError(concat("planner ", inQuotes(name),
                                " is not known; expected SpeculativeAStar or one of OMPL's, such ",
                                "as RRTConnect or BITstar"));
    ob::PlannerPtr planner = entry->make(si);
    for (const auto& [key, value] : parameters)
        if (key == "name")
            planner->setName(value);
        else
            setParameter(*planner, name, key, value);
    return planner;
}
}  // namespace specplan::problems
