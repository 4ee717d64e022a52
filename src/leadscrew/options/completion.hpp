#pragma once
// Scripts by which shells complete a program's words: its commands, their options, and what the values of those may be.
// All is in the script: completing runs no program. What is the same for all programs stands in completion.bash, .zsh and
// .fish; what the options say takes the place of the @MARKS@ there.

#include <leadscrew/options/options.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace leadscrew::options {

enum class Shell { bash, zsh, fish };

/// The script for one shell, ready to be sourced, or to be put where the shell looks for it.
std::string completion_script(const Program& program, Shell shell);

// The three that it is one of.
std::string bash_completion(const Program& program);
std::string zsh_completion(const Program& program);
std::string fish_completion(const Program& program);

extern const std::string_view completion_bash, completion_zsh, completion_fish;

/// The text with what is to stand for each @MARK@.
std::string filled(std::string_view text, const std::vector<std::pair<std::string_view, std::string>>& texts);

}  // namespace leadscrew::options
