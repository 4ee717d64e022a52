#include <algorithm>
#include <leadscrew/options/completion.hpp>

namespace leadscrew::options {

std::string filled(std::string_view text, const std::vector<std::pair<std::string_view, std::string>>& texts) {
  std::string written;
  while (!text.empty()) {
    const std::size_t mark = std::min(text.find('@'), text.size());
    written += text.substr(0, mark);
    text.remove_prefix(mark);
    if (text.empty()) break;
    const std::size_t end = text.find('@', 1);
    const std::string_view name = text.substr(1, end == std::string_view::npos ? end : end - 1);
    const auto found = std::ranges::find(texts, name, &std::pair<std::string_view, std::string>::first);
    const bool is_mark = end != std::string_view::npos && found != texts.end();
    written += is_mark ? std::string_view(found->second) : "@";
    text.remove_prefix(is_mark ? end + 1 : 1);
  }
  return written;
}

std::string completion_script(const Program& program, Shell shell) {
  switch (shell) {
    case Shell::bash:
      return bash_completion(program);
    case Shell::zsh:
      return zsh_completion(program);
    case Shell::fish:
      return fish_completion(program);
  }
  return {};
}

}  // namespace leadscrew::options
