#pragma once
// Text for pages and pictures: numbers as people read them, and foreign text that cannot become markup.

#include <cstddef>
#include <string>
#include <string_view>

namespace leadscrew::markup {

/// Appends pieces of text.
template <class... Pieces>
void put(std::string& out, const Pieces&... pieces) {
  (out.append(std::string_view(pieces)), ...);
}

/// Text as content or attribute of HTML and SVG: & < > " ' as references, bytes that are no UTF-8 and control
/// characters as U+FFFD; cut after `longest` bytes.
std::string escaped(std::string_view text, std::size_t longest = 300);

/// A fixed number of decimals, '.' as decimal point, for coordinates inside markup.
std::string fixed(double value, int decimals);

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

/// For people: about so many significant digits, a true minus sign, narrow spaces between thousands; "—" when not
/// finite.
std::string readable(double value, int digits = 4);

/// "12.345 s", "2:03.456" from a minute on, "1:02:03.456" from an hour on.
std::string readable_time(double seconds);

/// A small distance in the unit that suits it: mm, µm or nm.
std::string readable_distance(double mm);

std::string percent(double ratio);

/// Steps of 1, 2 or 5 times a power of ten that divide a range into about `wanted` parts.
double tick_step(double range, int wanted);

/// Decimals that ticks of such a step need.
int tick_decimals(double step);

}  // namespace leadscrew::markup
