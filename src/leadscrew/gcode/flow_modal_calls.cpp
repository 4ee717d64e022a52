// G66, a macro that is called behind each block that moves, until G67 (Fanuc 0i operator's manual, "Modal Call").

#include <leadscrew/gcode/flow.hpp>
#include <utility>

namespace leadscrew::gcode {

Flow::Next Flow::begin_modal_call(Call call, const Statement& at) {
  if (active_modal_calls_ != modal_calls_.size()) return modal_call_inside(at);
  if (modal_calls_.size() == most_modal_calls) {
    return error(at, "calls-too-deep", "G66 is in force " + std::to_string(most_modal_calls) + " times already",
                 "end one by G67");
  }
  call.is_modal = true;
  modal_calls_.push_back(std::move(call));
  activate_modal_calls(modal_calls_.size());
  return Next::line;
}

Flow::Next Flow::end_modal_call(std::uint32_t column) {
  Statement at;
  at.column = column;
  if (active_modal_calls_ != modal_calls_.size()) return modal_call_inside(at);
  if (!modal_calls_.empty()) modal_calls_.pop_back();
  activate_modal_calls(modal_calls_.size());
  return Next::line;
}

Flow::Next Flow::modal_call_inside(const Statement& at) {
  return error(at, "modal-call-inside", "G66 or G67 stands in a macro that G66 calls",
               "give them in the program that moves; G65 calls a macro here");
}

void Flow::activate_modal_calls(std::size_t count) {
  active_modal_calls_ = count;
  modal_.calls_macro = count > 0;
  if (modal_.calls_macro) modal_.is_plain = false;
}

Flow::Next Flow::call_modal(const TextLine& line) {
  if (active_modal_calls_ == 0) return Next::line;
  const Call& call = modal_calls_[active_modal_calls_ - 1];
  if (call.left == 0) return Next::line;
  text_.keep(line);
  activate_modal_calls(active_modal_calls_ - 1);
  Statement at;
  at.column = 1;
  return begin_call(call, at);
}

}  // namespace leadscrew::gcode
