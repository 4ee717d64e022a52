#include <leadscrew/base/digits.hpp>
#include <leadscrew/trace/event_writer.hpp>

namespace leadscrew::trace {

EventWriter::EventWriter(base::ByteSink sink, base::Period period) : rows_(std::move(sink), 256), period_(period) {
  rows_.text() = "tick,t,s,line,code,output,value,q\n";
}

base::Result<void> EventWriter::write(const base::PassedEvent& event) {
  if (!rows_.state()) return rows_.state();
  std::string& text = rows_.text();
  char digits[base::digits_room];
  const auto put = [&](const char* end) { text.append(digits, static_cast<std::size_t>(end - digits)); };
  put(base::write_integer(digits, base::count(event.tick)));
  text += ',';
  put(base::write_digits(digits, base::seconds(event.tick, period_)));
  text += ',';
  put(base::write_digits(digits, event.path_length));
  text += ',';
  put(base::write_integer(digits, base::number(event.line)));
  text += ',';
  text += base::code_of(event);
  text += ',';
  if (base::has_output(event.kind)) put(base::write_integer(digits, event.output));
  text += ',';
  if (base::has_value(event.kind)) put(base::write_digits(digits, event.value));
  text += ',';
  if (base::has_q(event.kind)) put(base::write_digits(digits, event.q));
  text += '\n';
  return rows_.flush_if_full();
}

}  // namespace leadscrew::trace
