// Help, manual pages, completion of shells and the version: what they say against the options as data, and what shells
// and formatters make of them.

#include <gtest/gtest.h>
#include <stdio.h>

#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/options/completion.hpp>
#include <leadscrew/options/manual.hpp>
#include <regex>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_about {

using options::Option;
using Words = std::vector<std::string>;

/// The commands as the command line has them.
struct Described {
  Arguments arguments;
  options::Program program{"leadscrew", "CNC part programs into motion.", "0"};
  Described() { describe_program(program, arguments); }
};

Names option_names(const Command& command) {
  Names names = {"--help"};
  for (const Option& option : command.options()) {
    if (!option.is_word()) names.insert(option.name);
  }
  return names;
}

/// What the expression's first group matches in the text, each once.
Names all_matches(const std::string& text, const std::string& expression) {
  Names found;
  const std::regex pattern(expression);
  for (auto match = std::sregex_iterator(text.begin(), text.end(), pattern); match != std::sregex_iterator(); ++match)
    found.insert((*match)[1]);
  return found;
}

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin);
  if (from == std::string::npos) return {};
  return text.substr(from, text.find(end, from + begin.size()) - from);
}

bool is_installed(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
}

/// Standard output and standard error of a line that bash runs in the folder.
std::string shell(const Folder& folder, const std::string& line) {
  folder.write("line.sh", line);
  const std::string started = "cd '" + folder.path().string() + "' && bash --norc line.sh 2>&1";
  FILE* const pipe = ::popen(started.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("no pipe");
  std::string text;
  for (int c = 0; (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
  ::pclose(pipe);
  return text;
}

Names lines_of(const std::string& text) {
  return all_matches(text, "([^\n]+)\n");
}

/// What bash offers for the last of the words.
Names bash_offers(const Folder& folder, const Words& words) {
  std::string line = "source leadscrew.bash\nCOMP_WORDS=(leadscrew";
  for (const std::string& word : words) line += " '" + word + "'";
  line += ")\nCOMP_CWORD=" + std::to_string(words.size()) + "\n_leadscrew\n";
  line += "((${#COMPREPLY[@]})) && printf '%s\\n' \"${COMPREPLY[@]}\"\n";
  return lines_of(shell(folder, line));
}

Names fish_offers(const Folder& folder, const std::string& line) {
  const std::string text = shell(folder, "fish --no-config -c 'source leadscrew.fish; complete -C \"" + line + "\"'\n");
  return all_matches(text, "(?:^|\n)([^\t\n]+)");
}

/// A folder with the scripts, a few files, and nothing else.
class Completion : public ::testing::Test {
 protected:
  Completion() {
    for (const char* name : {"part.ngc", "Other.NC", "mill.toml", "words.csv", "notes.txt"}) folder.write(name, "");
    std::filesystem::create_directory(folder.path() / "jobs");
    for (const std::string shell_name : {"bash", "zsh", "fish"}) {
      const auto script = leadscrew(folder, {"completion", shell_name});
      EXPECT_EQ(script.status, 0) << script.errors;
      folder.write("leadscrew." + shell_name, script.output);
    }
  }

  Folder folder;
  Described described;
};

TEST(Help, OfEveryCommandNamesItsOptionsAndNoOther) {
  const Folder folder;
  Described described;
  for (const Command& command : described.program.commands) {
    const auto help = leadscrew(folder, {command.name(), "--help"});
    EXPECT_EQ(all_matches(between(help.output, "\nOptions:\n", "\n\n") + "\n", "\n  (?:-h,)?(--[a-z-]+)"),
              option_names(command))
        << command.name();
    const auto asked = leadscrew(folder, {"help", command.name()});
    EXPECT_EQ(asked.output, help.output);
    EXPECT_EQ(asked.status, 0);
  }
  EXPECT_EQ(leadscrew(folder, {"help"}).output, leadscrew(folder, {"--help"}).output);
}

TEST(Help, OfNoCommandSaysWhichThereAre) {
  const Folder folder;
  const auto near = leadscrew(folder, {"help", "chek"});
  EXPECT_EQ(near.status, 2);
  EXPECT_EQ(near.errors, "leadscrew: error: no command \"chek\"; did you mean check?\n    hint: leadscrew --help\n");
  EXPECT_TRUE(contains(leadscrew(folder, {"help", "nonsense"}).errors, "there are run, check"));
}

TEST(Manual, PagesNameEveryOptionAndNoOther) {
  Described described;
  for (const Command& command : described.program.commands) {
    const std::string page = options::manual_page(described.program, &command);
    std::string plain = std::regex_replace(between(page, ".SH OPTIONS\n", "\n.SH "), std::regex(R"(\\-)"), "-");
    Names named = all_matches(plain, R"(\.TP\n\\fB(--[a-z-]+)\\fR)");
    EXPECT_TRUE(contains(plain, ".TP\n\\fB-h\\fR, \\fB--help\\fR\n")) << page;
    named.insert("--help");
    EXPECT_EQ(named, option_names(command)) << command.name();
    for (const Option& option : command.options()) {
      if (!option.is_word()) continue;
      EXPECT_TRUE(contains(plain, ".TP\n\\fI" + option.name + "\\fR\n")) << option.name;
    }
    EXPECT_TRUE(contains(page, ".SH SEE ALSO\n\\fBleadscrew\\fR(1)")) << page;
  }
}

TEST(Manual, PagesAreFormattedWithoutAWarning) {
  if (!is_installed("groff")) GTEST_SKIP() << "groff is not installed";
  const Folder folder;
  Described described;
  std::string line = "exec 2>&1\n";
  Names pages = {"leadscrew.1"};
  folder.write("leadscrew.1", leadscrew(folder, {"help", "--man"}).output);
  for (const Command& command : described.program.commands) {
    const std::string name = "leadscrew-" + command.name() + ".1";
    pages.insert(folder.write(name, leadscrew(folder, {"help", "--man", command.name()}).output));
  }
  for (const std::string& page : pages) {
    EXPECT_EQ(shell(folder, "groff -man -ww -z " + page), "") << page;
    if (is_installed("mandoc")) {
      EXPECT_EQ(shell(folder, "mandoc -T lint -W warning " + page), "") << page;
    }
    const std::string shown = shell(folder, "groff -man -Tutf8 -P-cbou " + page + " | tr -s ' '");
    EXPECT_TRUE(contains(shown, "\nNAME\n " + page.substr(0, page.find('.')) + " - ")) << shown;
  }
  folder.write("wrong.1", ".TH A 1\n.SH NAME\n.nosuchmacro\n");
  EXPECT_TRUE(contains(shell(folder, "groff -man -ww -z wrong.1"), "nosuchmacro"));
  if (is_installed("mandoc")) {
    EXPECT_TRUE(contains(shell(folder, "mandoc -T lint -W warning wrong.1"), "missing date"));
  }
}

TEST(Manual, TextIsShownAsItStands) {
  options::Program program("tool", "It's a \\tool of 10 µm", "1");
  std::string target;
  program.itself.word("NAME", ".like this", target);
  program.itself.help("Examples:\n  .tool ^~`\n\nNotes.\n");
  const std::string page = options::manual_page(program, nullptr);
  EXPECT_TRUE(contains(page, "tool \\- It\\(aqs a \\etool of 10 \\[u00B5]m\n")) << page;
  EXPECT_TRUE(contains(page, "\n\\&.like this\n")) << page;
  EXPECT_TRUE(contains(page, ".SH EXAMPLES\n.nf\n  .tool \\(ha\\(ti\\(ga\n.fi\n.SH NOTES\nNotes.\n")) << page;
}

TEST_F(Completion, OfBashOffersCommandsAndTheirOptions) {
  Names commands = {"--version", "--json", "--help", "-h"};
  for (const Command& command : described.program.commands) {
    commands.insert(command.name());
    Names names = option_names(command);
    EXPECT_EQ(bash_offers(folder, {command.name(), "--"}), names) << command.name();
    names.insert("-h");
    EXPECT_EQ(bash_offers(folder, {command.name(), "-"}), names) << command.name();
  }
  EXPECT_EQ(bash_offers(folder, {""}), commands);
  EXPECT_EQ(bash_offers(folder, {"s"}), (Names{"serve", "study", "simulate", "surfaces", "sweep"}));
  EXPECT_EQ(bash_offers(folder, {"nonsense", "-"}), Names());
}

TEST_F(Completion, OfBashKnowsWhatValuesMayBe) {
  EXPECT_EQ(bash_offers(folder, {"run", "--mode", ""}), (Names{"exact-stop", "blend"}));
  EXPECT_EQ(bash_offers(folder, {"run", "part.ngc", "--mode", "=", "b"}), Names{"blend"});
  EXPECT_EQ(bash_offers(folder, {"run", "part.ngc", "--mode", "="}), (Names{"exact-stop", "blend"}));
  EXPECT_EQ(bash_offers(folder, {"run", "--machine", "m"}), (Names{"mill.toml", "mill3"}));
  EXPECT_EQ(bash_offers(folder, {"run", "--out", ""}), Names{"jobs"});
  EXPECT_EQ(bash_offers(folder, {"run", "--period", ""}), Names());
  EXPECT_EQ(bash_offers(folder, {"run", "--trace", ""}), (Names{"words.csv", "jobs"}));
  EXPECT_EQ(bash_offers(folder, {"run", "--tools", "n"}), Names{"notes.txt"});  // better than nothing
  EXPECT_EQ(bash_offers(folder, {"pulse", "--method", "d"}), Names{"dda"});
  EXPECT_EQ(bash_offers(folder, {"pulse", "--method", "dda,k"}), Names{"dda,koren"});
  EXPECT_TRUE(bash_offers(folder, {"study", "b"}).contains("butterfly"));
  EXPECT_EQ(bash_offers(folder, {"study", "butterfly", ""}), Names());
  EXPECT_EQ(bash_offers(folder, {"completion", ""}), (Names{"bash", "zsh", "fish"}));
  EXPECT_EQ(bash_offers(folder, {"help", "dr"}), Names{"drive"});
}

TEST_F(Completion, OfBashKnowsWhichWordIsTyped) {
  EXPECT_EQ(bash_offers(folder, {"run", "p"}), Names{"part.ngc"});
  EXPECT_EQ(bash_offers(folder, {"run", "part.ngc", "O"}), Names{"Other.NC"});
  EXPECT_EQ(bash_offers(folder, {"verify", "w"}), Names{"words.csv"});
  EXPECT_EQ(bash_offers(folder, {"verify", "--period", "1ms", "words.csv", "p"}), Names{"part.ngc"});
  EXPECT_EQ(bash_offers(folder, {"verify", "--json", "w"}), Names{"words.csv"});
  // Readline parts words at colons, and replaces what is behind the last one.
  EXPECT_EQ(bash_offers(folder, {"run", "curve", ":", "but"}), Names{"butterfly"});
  EXPECT_TRUE(bash_offers(folder, {"run", "curve", ":"}).contains("circle"));
  EXPECT_TRUE(bash_offers(folder, {"run", "cur"}).contains("curve:circle"));
}

TEST_F(Completion, OfFishOffersTheSame) {
  if (!is_installed("fish")) GTEST_SKIP() << "fish is not installed";
  for (const Command& command : described.program.commands)
    EXPECT_EQ(fish_offers(folder, "leadscrew " + command.name() + " --"), option_names(command)) << command.name();
  Names commands;
  for (const Command& command : described.program.commands) commands.insert(command.name());
  EXPECT_EQ(fish_offers(folder, "leadscrew "), commands);
  EXPECT_EQ(fish_offers(folder, "leadscrew run --mode "), (Names{"exact-stop", "blend"}));
  EXPECT_EQ(fish_offers(folder, "leadscrew run --mode=b"), Names{"--mode=blend"});
  EXPECT_EQ(fish_offers(folder, "leadscrew run --machine m"), (Names{"mill.toml", "mill3"}));
  EXPECT_EQ(fish_offers(folder, "leadscrew run --out "), Names{"jobs/"});
  EXPECT_EQ(fish_offers(folder, "leadscrew run --trace "), (Names{"words.csv", "jobs/"}));
  EXPECT_EQ(fish_offers(folder, "leadscrew pulse --method dda,k"), Names{"dda,koren"});
  EXPECT_EQ(fish_offers(folder, "leadscrew verify w"), Names{"words.csv"});
  EXPECT_EQ(fish_offers(folder, "leadscrew verify --period 1ms words.csv p"), Names{"part.ngc"});
  EXPECT_EQ(fish_offers(folder, "leadscrew help dr"), Names{"drive"});
}

TEST_F(Completion, OfZshNamesEveryOptionAndNoOther) {
  const std::string script = folder.read("leadscrew.zsh");
  for (const Command& command : described.program.commands) {
    const std::string part = between(script, "    " + command.name() + ")\n", ";;");
    EXPECT_EQ(all_matches(part, "(--[a-z-]+)(?:=\\[|\\[|\\})"), option_names(command)) << command.name();
  }
  if (!is_installed("zsh")) GTEST_SKIP() << "zsh is not installed";
  EXPECT_EQ(shell(folder, "zsh -n leadscrew.zsh"), "");
}

TEST(CompletionScript, OfAnUnknownShellIsRefused) {
  const Folder folder;
  const auto refused = leadscrew(folder, {"completion", "tcsh"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(contains(refused.errors, "tcsh is none of bash, zsh, fish")) << refused.errors;
}

TEST(Version, AsJsonHasTheKeysOfItsSchema) {
  const Folder folder;
  const auto asked = leadscrew(folder, {"--version", "--json"});
  EXPECT_EQ(asked.status, 0);
  EXPECT_EQ(asked.errors, "");
  const Json version = asked.json();
  std::ifstream file(source_folder / "docs/schemas/version.json");
  const Json schema = Json::parse(file);
  EXPECT_FALSE(schema["additionalProperties"].get<bool>());
  Names described, required, written;
  for (const auto& [key, property] : schema["properties"].items()) {
    described.insert(key);
    EXPECT_FALSE(property["description"].get<std::string>().empty()) << key;
  }
  for (const auto& key : schema["required"]) required.insert(key.get<std::string>());
  for (const auto& [key, value] : version.items()) written.insert(key);
  EXPECT_EQ(written, described);
  EXPECT_EQ(written, required);
  EXPECT_EQ(version["schema"], schema["properties"]["schema"]["const"]);
  EXPECT_EQ("leadscrew " + version["version"].get<std::string>() + "\n", leadscrew(folder, {"--version"}).output);
  EXPECT_EQ(leadscrew(folder, {"--json", "--version"}).output, asked.output);
  const auto& kernels = version["kernels"];
  EXPECT_NE(std::find(kernels.begin(), kernels.end(), version["kernel"]), kernels.end());
  const Described program;
  Names commands, listed;
  for (const Command& command : program.program.commands) commands.insert(command.name());
  for (const auto& command : version["commands"]) listed.insert(command.get<std::string>());
  EXPECT_EQ(listed, commands);
}

TEST(Version, IsNotJsonAlone) {
  const Folder folder;
  const auto alone = leadscrew(folder, {"--json"});
  EXPECT_EQ(alone.status, 2);
  EXPECT_TRUE(contains(alone.errors, "no command")) << alone.errors;
}

}  // namespace test_about
}  // namespace leadscrew::cli::testing
