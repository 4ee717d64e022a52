#include <charconv>
#include <leadscrew/surfaces/surface_text.hpp>

namespace leadscrew::surfaces {

namespace {

void append_word(std::string& text, char letter, double value) {
  char buffer[400];  // 5e-324 has 326 characters
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed);
  text += letter;
  text.append(buffer, end.ptr);
}

void append_count(std::string& text, char letter, std::size_t value) {
  text += ' ';
  text += letter;
  text += std::to_string(value);
}

}  // namespace

std::string definition_text(const SurfaceForm& form, int number) {
  std::string text = "G6.4 D" + std::to_string(number);
  append_count(text, 'P', static_cast<std::size_t>(form.degree[0]) + 1);
  append_count(text, 'Q', static_cast<std::size_t>(form.degree[1]) + 1);
  append_count(text, 'I', form.count[0]);
  append_count(text, 'J', form.count[1]);
  text += '\n';
  // Every direction has more points than its degree, and the other at least two: there are never fewer points than knots.
  std::array<bool, 2> tells_knots{};
  for (std::size_t d = 0; d < 2; ++d) tells_knots[d] = form.knots[d] != uniform_knots(form.count[d], form.degree[d]);
  for (std::size_t i = 0; i < form.net.size(); ++i) {
    const NetPoint& point = form.net[i];
    append_word(text, 'X', point.position[0]);
    append_word(text += ' ', 'Y', point.position[1]);
    append_word(text += ' ', 'Z', point.position[2]);
    if (point.weight != 1) append_word(text += ' ', 'R', point.weight);
    for (std::size_t d = 0; d < 2; ++d) {
      if (tells_knots[d] && i < form.knots[d].size()) append_word(text += ' ', d == 0 ? 'K' : 'L', form.knots[d][i]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace leadscrew::surfaces
