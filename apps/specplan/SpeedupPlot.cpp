// SPDX-License-Identifier: BSD-3-Clause
#include "SpeedupPlot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <ostream>
#include <set>
#include <sstream>
#include <system_error>

#include "Outputs.h"
#include "specplan/problems/InputError.h"
#include "specplan/problems/TextFile.h"

namespace specplan::command
{
using problems::concat;
using problems::InputError;

namespace
{
/// In gnuplot's single quotes, where only the quote itself is special.
std::string quoted(const std::string& text)
{
    std::string out = "'";
    for (const char c : text)
        out += c == '\'' ? "''" : std::string(1, c);
    return out + "'";
}

/// policy -> threads -> speed-ups of all problems
using Curves = std::map<std::string, std::map<unsigned, std::vector<double>>>;

Curves curvesOf(const std::vector<Run>& runs)
{
    Curves curves;
    for (const Run& run : runs)
        curves[run.settings.speculationPolicy][run.report.threads].push_back(run.report.speedup);
    return curves;
}

double geometricMean(const std::vector<double>& values)
{
    double logs = 0.0;
    for (const double value : values)
        logs += std::log(value);
    return std::exp(logs / static_cast<double>(values.size()));
}

std::string plotTitle(const std::vector<Run>& runs)
{
    std::set<std::string> problems;
    for (const Run& run : runs)
        problems.insert(run.problem);
    return problems.size() == 1 ? *problems.begin() : concat("geometric mean over ", problems.size(), " problems");
}

std::string makeScript(const std::string& file, const std::vector<Run>& runs)
{
    std::ostringstream script;
    const Curves curves = curvesOf(runs);
    unsigned most = 2;
    int number = 0;
    for (const auto& [policy, points] : curves)
    {
        most = std::max(most, points.rbegin()->first);
        script << "$curve" << number++ << " << END\n";
        for (const auto& [threads, speedups] : points)
            script << threads << ' ' << geometricMean(speedups) << '\n';
        script << "END\n";
    }
    script << "set terminal svg size 720,480 font 'sans-serif,13' background rgb 'white'\nset output " << quoted(file)
           << "\nset title " << quoted(plotTitle(runs)) << " noenhanced\nset xlabel 'threads'\n"
           << "set ylabel 'speed-up over sequential A*'\nset logscale xy 2\nset xrange [1:" << most
           << "]\nset yrange [0.8:" << 1.1 * most << "]\nset key top left\nset grid\n"
           << "plot x with lines dashtype 2 linecolor rgb '#999999' title 'one times the threads'";
    number = 0;
    for (const auto& [policy, points] : curves)
        script << ", $curve" << number++ << " with linespoints linewidth 2 pointtype 7 title " << quoted(policy);
    script << "\nset output\n";
    return script.str();
}

/// A folder for what gnuplot draws, gone at the end.
class TemporaryFolder
{
public:
    TemporaryFolder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "specplan-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw InputError("--plot: expected a folder for temporary files that can be written");
        path_ = name;
    }

    ~TemporaryFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const noexcept
    {
        return path_;
    }

private:
    std::filesystem::path path_;
};
}  // namespace

void requireGnuplot()
{
    if (std::system("gnuplot --version >/dev/null 2>&1") != 0)  // NOLINT(cert-env33-c): a fixed command
        throw InputError("--plot: gnuplot is needed to draw the plot and was not found");
}

void plotSpeedup(const std::string& file, const std::vector<Run>& runs)
{
    const TemporaryFolder folder;
    const std::string picture = folder.path() / "plot.svg";
    int status = -1;
    if (std::FILE* gnuplot = popen("gnuplot -", "w"))  // NOLINT(cert-env33-c): a fixed command
    {
        const std::string script = makeScript(picture, runs);
        std::fwrite(script.data(), 1, script.size(), gnuplot);
        status = pclose(gnuplot);
    }
    if (status != 0)
        throw InputError(file, 0, "cannot be written: gnuplot did not draw the plot");
    const std::string svg = problems::readText(picture);
    writeOutput(file, [&svg](std::ostream& out) { out << svg; });
}
}  // namespace specplan::command
