// SPDX-License-Identifier: BSD-3-Clause
#include "Completion.h"

#include <algorithm>
#include <cctype>
#include <ostream>
#include <vector>

namespace specplan::command
{
namespace
{
std::vector<const CLI::Option*> optionsOf(const CLI::App& app)
{
    return app.get_options([](const CLI::Option* option)
                           { return !option->get_positional() && !option->get_group().empty(); });
}

std::vector<const CLI::App*> subcommandsOf(const CLI::App& app)
{
    return app.get_subcommands([](const CLI::App*) { return true; });
}

/// "-h,--help" as separate words.
std::string namesOf(const CLI::Option& option)
{
    std::string names = option.get_name(false, true);
    std::ranges::replace(names, ',', ' ');
    return names;
}

/// The words that an option takes, separated by blanks; empty if it takes something else.
std::string choicesOf(const CLI::Option& option)
{
    std::string words = option.get_type_name();
    const bool isChoice = words.find('|') != std::string::npos &&
                          std::ranges::all_of(words, [](unsigned char c) { return std::islower(c) != 0 || c == '|'; });
    if (!isChoice)
        return {};
    std::ranges::replace(words, '|', ' ');
    return words;
}

bool takesFile(const CLI::Option& option)
{
    return option.get_type_name() == "FILE";
}

void writeBashValues(std::ostream& out, const CLI::App& app)
{
    for (const CLI::Option* option : optionsOf(app))
    {
        if (option->get_items_expected_max() == 0)
            continue;
        std::string patterns = namesOf(*option);
        std::ranges::replace(patterns, ' ', '|');
        out << "        " << app.get_name() << '/' << patterns << ") ";
        if (takesFile(*option))
            out << "COMPREPLY=($(compgen -f -- \"$word\"))";
        else
            out << "COMPREPLY=($(compgen -W '" << choicesOf(*option) << "' -- \"$word\"))";
        out << "; return ;;\n";
    }
}

void writeBash(std::ostream& out, const CLI::App& app)
{
    std::string all;
    for (const CLI::App* subcommand : subcommandsOf(app))
        all += subcommand->get_name() + ' ';
    out << "# bash completion for specplan\n_specplan()\n{\n"
           "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]}\n"
           "    COMPREPLY=()\n"
           "    if ((COMP_CWORD == 1)); then\n"
           "        COMPREPLY=($(compgen -W '"
        << all << "--help --version' -- \"$word\"))\n        return\n    fi\n    case $command/$before in\n";
    for (const CLI::App* subcommand : subcommandsOf(app))
        writeBashValues(out, *subcommand);
    out << "    esac\n    if [[ $word != -* ]]; then\n        COMPREPLY=($(compgen -f -- \"$word\"))\n        return\n"
           "    fi\n    case $command in\n";
    for (const CLI::App* subcommand : subcommandsOf(app))
    {
        out << "        " << subcommand->get_name() << ") COMPREPLY=($(compgen -W '";
        for (const CLI::Option* option : optionsOf(*subcommand))
            out << namesOf(*option) << ' ';
        out << "' -- \"$word\")) ;;\n";
    }
    out << "    esac\n}\ncomplete -o filenames -F _specplan specplan\n";
}

/// Text inside of an option's description: what ends it, or the quotes around it, is left out or escaped.
std::string zshText(const std::string& text)
{
    std::string out;
    for (const char letter : text)
        if (letter == '[' || letter == ']' || letter == ':')
            out += std::string("\\") + letter;
        else if (letter == '\'')
            out += "'\\''";
        else
            out += letter;
    return out;
}

void writeZshOption(std::ostream& out, const CLI::Option& option)
{
    const std::string names = namesOf(option);
    for (std::size_t at = 0; at < names.size();)
    {
        const std::size_t end = std::min(names.find(' ', at), names.size());
        out << " \\\n                '" << names.substr(at, end - at) << '[' << zshText(option.get_description())
            << ']';
        if (option.get_items_expected_max() > 0)
            out << ':' << zshText(option.get_type_name()) << ':';
        if (takesFile(option))
            out << "_files";
        else if (const std::string words = choicesOf(option); !words.empty())
            out << '(' << words << ')';
        out << '\'';
        at = end + 1;
    }
}

void writeZsh(std::ostream& out, const CLI::App& app)
{
    out << "#compdef specplan\n_specplan()\n{\n    local -a commands\n    commands=(\n";
    for (const CLI::App* subcommand : subcommandsOf(app))
        out << "        '" << subcommand->get_name() << ':' << zshText(subcommand->get_description()) << "'\n";
    out << "    )\n    if ((CURRENT == 2)); then\n        _describe subcommand commands\n        return\n    fi\n"
           "    local command=$words[2]\n    shift words\n    ((CURRENT--))\n    case $command in\n";
    for (const CLI::App* subcommand : subcommandsOf(app))
    {
        out << "        " << subcommand->get_name() << ")\n            _arguments -s";
        for (const CLI::Option* option : optionsOf(*subcommand))
            writeZshOption(out, *option);
        out << " \\\n                '*:problem:_files'\n            ;;\n";
    }
    out << "    esac\n}\n_specplan \"$@\"\n";
}
}  // namespace

void writeCompletion(std::ostream& out, const CLI::App& app, const std::string& shell)
{
    if (shell == "bash")
        writeBash(out, app);
    else
        writeZsh(out, app);
}
}  // namespace specplan::command
