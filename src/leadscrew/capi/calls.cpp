#include "calls.hpp"

#include <string>

namespace leadscrew::capi {

namespace {

/// "end.x"
std::string field_of(const base::Subject& subject) {
  std::string field(subject.field);
  if (field.empty() || !subject.axis) return field;
  const char letter = base::letter(*subject.axis);
  return field + "." + static_cast<char>(letter - 'A' + 'a');
}

}  // namespace

leadscrew_error error_of(const base::Diagnostic& diagnostic) {
  leadscrew_error error{};
  error.size = sizeof error;
  error.severity = static_cast<std::int32_t>(diagnostic.severity);
  error.line = diagnostic.place.line;
  error.column = diagnostic.place.column;
  copy_text(error.code, diagnostic.code);
  copy_text(error.message, diagnostic.message);
  copy_text(error.hint, diagnostic.hint);
  copy_text(error.file, diagnostic.place.file);
  copy_text(error.field, field_of(diagnostic.subject));
  return error;
}

void tell(leadscrew_error* error, const base::Diagnostic& diagnostic) {
  fill(error, error_of(diagnostic));
}

int misuse(leadscrew_error* error, const char* message) {
  tell(error, base::problem("misuse", message, {}));
  return LEADSCREW_MISUSE;
}

int rejected(leadscrew_error* error, const base::Diagnostic& diagnostic) {
  tell(error, diagnostic);
  if (diagnostic.code == "interrupted") return LEADSCREW_INTERRUPTED;
  return diagnostic.code.substr(0, 3) == "io-" ? LEADSCREW_INPUT : LEADSCREW_REJECTED;
}

}  // namespace leadscrew::capi
