#include <leadscrew/markup/markup.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace leadscrew::markup {
namespace {

constexpr std::string_view minus = "\xE2\x88\x92";
constexpr std::string_view narrow_space = "\xE2\x80\xAF";
constexpr std::string_view replacement = "\xEF\xBF\xBD";
constexpr std::string_view dash = "\xE2\x80\x94";

/// Length of the well-formed UTF-8 sequence at the start of the text (RFC 3629); 0 when there is none.
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  const unsigned char second = byte(1);
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool surrogate = first == 0xED && second > 0x9F;
  const bool beyond = first == 0xF4 && second > 0x8F;
  const bool control = first == 0xC2 && second < 0xA0;
  const bool noncharacter = first == 0xEF && second == 0xBF && byte(2) >= 0xBE;
  return overlong || surrogate || beyond || control || noncharacter ? 0 : length;
}

std::string grouped(std::string digits) {
  const std::size_t end = std::min(digits.find('.'), digits.size());
  if (end < 5) return digits;
  for (std::size_t at = end; at > 3;) {
    at -= 3;
    digits.insert(at, narrow_space);
  }
  return digits;
}

}  // namespace

std::string escaped(std::string_view text, std::size_t longest) {
  std::string out;
  std::size_t at = 0;
  while (at < text.size() && at < longest) {
    const std::string_view rest = text.substr(at);
    const char c = rest[0];
    const std::size_t length = sequence_length(rest);
    at += std::max<std::size_t>(length, 1);
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (c == '\'')
      out += "&#39;";
    else if (c == '\t' || c == '\n')
      out += c;
    else if (c == '\r')
      continue;
    else if (length == 0 || (length == 1 && (c < 0x20 || c == 0x7F)))
      out += replacement;
    else
      out += rest.substr(0, length);
  }
  if (at < text.size()) out += "…";
  return out;
}

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) value = 0;
  char text[400];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals).ptr;
  std::string out(text, end);
  if (out.find('.') != std::string::npos) {
    out.erase(out.find_last_not_of('0') + 1);
    if (out.back() == '.') out.pop_back();
  }
  return out == "-0" ? "0" : out;
}

std::string base64(std::string_view bytes) {
  constexpr char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : alphabet[three >> (18 - 6 * k) & 63];
  }
  return text;
}

std::string readable(double value, int digits) {
  if (!std::isfinite(value)) return std::string(dash);
  if (value == 0) return "0";
  const double magnitude = std::fabs(value);
  std::string out;
  if (magnitude >= 1e12 || magnitude < 1e-9) {
    char text[64];
    out.assign(text, std::to_chars(text, text + sizeof text, magnitude, std::chars_format::scientific, 2).ptr);
  } else {
    out =
        grouped(fixed(magnitude, std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(magnitude))), 0, 15)));
  }
  return value < 0 ? std::string(minus) + out : out;
}

std::string readable_time(double seconds) {
  if (!std::isfinite(seconds) || std::fabs(seconds) > 1e12) return std::string(dash);
  const auto total = static_cast<std::int64_t>(std::llround(std::max(seconds, 0.0) * 1000));
  const auto padded = [](std::int64_t value, std::size_t width) {
    const std::string digits = std::to_string(value);
    return std::string(width > digits.size() ? width - digits.size() : 0, '0') + digits;
  };
  const std::string thousandths = padded(total % 1000, 3);
  if (total < 60'000) return std::to_string(total / 1000) + "." + thousandths + " s";
  const std::int64_t hours = total / 3'600'000, minutes = total / 60'000 % 60;
  return (hours > 0 ? std::to_string(hours) + ":" + padded(minutes, 2) : std::to_string(minutes)) + ":" +
         padded(total / 1000 % 60, 2) + "." + thousandths;
}

std::string readable_distance(double mm) {
  if (!std::isfinite(mm)) return std::string(dash);
  const double magnitude = std::fabs(mm);
  if (magnitude == 0) return "0 µm";
  if (magnitude < 1e-7) return "below 0.1 nm";
  if (magnitude < 1e-3) return readable(mm * 1e6, 3) + " nm";
  if (magnitude < 1) return readable(mm * 1e3, 3) + " µm";
  return readable(mm, 4) + " mm";
}

std::string percent(double ratio) {
  if (!std::isfinite(ratio)) return std::string(dash);
  return readable(ratio * 100, ratio > 0.9 && ratio < 1.1 ? 4 : 3) + " %";
}

double tick_step(double range, int wanted) {
  const double rough = std::max(range / wanted, 1e-9);
  const double decade = std::pow(10.0, std::floor(std::log10(rough)));
  const double part = rough / decade;
  return decade * (part < 1.5 ? 1 : part < 3.5 ? 2 : part < 7.5 ? 5 : 10);
}

int tick_decimals(double step) {
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 9);
}

}  // namespace leadscrew::markup
