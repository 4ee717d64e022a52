#pragma once
// Faces as lines of JSON, between the program that reads files and the one that asked it to:
//
//     {"format": "STEP", "unit": "mm"}
//     {"face": …}                                   as many as there are
//     {"end": true}           or, at any place,     {"problem": {"code": …, "message": …, "hint": …}}

#include <leadscrew/exchange/faces.hpp>
#include <leadscrew/json/json.hpp>

namespace leadscrew::exchange {

std::string line_of_header(const std::string& format, const std::string& unit);
std::string line_of(const Face& face);
std::string line_of_end();
std::string line_of_problem(std::string_view code, const std::string& message, const std::string& hint);

/// What the lines say, one after the other.
class FaceLines {
 public:
  /// False where the line cannot be understood, or comes at the wrong place.
  bool take(std::string_view line);
  /// The last line has come.
  bool ended() const { return ended_; }
  /// What kept the file from being read.
  const std::optional<Refusal>& problem() const { return problem_; }

  Faces faces;

 private:
  bool has_header_ = false, ended_ = false;
  std::optional<Refusal> problem_;
};

}  // namespace leadscrew::exchange
