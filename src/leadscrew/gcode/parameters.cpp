#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/parameters.hpp>

namespace leadscrew::gcode {

namespace {

// First parameter of a coordinate system; the tenth is its rotation.
int first_of_system(int number) {
  return 5201 + 20 * number;
}

}  // namespace

Parameters::Parameters() {
  const base::AxisVector zero{};
  set_axes(g28_home, zero);
  set_axes(g30_home, zero);
  set(g92_active, 0);
  set_axes(g92_shift, zero);
  set(current_system, 1);
  for (int system = 1; system <= 9; ++system) set_system(system, {});
  set(shows_debug, 1);
}

std::optional<double> Parameters::get(int number) const {
  const auto i = static_cast<std::size_t>(number);
  return given_[i] ? std::optional<double>(numbered_[i]) : std::nullopt;
}

void Parameters::set(int number, double value) {
  const auto i = static_cast<std::size_t>(number);
  numbered_[i] = value;
  given_[i] = true;
}

void Parameters::unset(int number) {
  given_[static_cast<std::size_t>(number)] = false;
}

std::optional<double> Parameters::get(const std::string& name) const {
  const auto found = named_.find(name);
  if (found == named_.end()) return std::nullopt;
  const Binding& binding = found->second;
  if (binding.depth != depth() && !(is_global(name) && binding.depth >= 0)) return std::nullopt;
  return binding.value;
}

bool Parameters::set(const std::string& name, double value) {
  auto found = named_.find(name);
  if (found == named_.end()) {
    if (named_.size() >= most_names) return false;
    found = named_.emplace(name, Binding{}).first;
  }
  Binding& binding = found->second;
  if (!is_global(name) && binding.depth != depth() && !calls_.empty()) {
    if (hidden_.size() >= most_hidden_names) return false;
    hidden_.push_back({&binding, binding});
  }
  binding = {value, depth()};
  return true;
}

bool Parameters::enter_call(std::span<const double> arguments) {
  if (calls_.size() >= most_calls) return false;
  returned_.reset();
  Call& call = calls_.emplace_back();
  call.given = 0;
  call.hidden = hidden_.size();
  call.locals = std::clamp(arguments.size(), std::size_t{locals}, std::size_t{macro_locals});
  for (std::size_t i = 0; i < call.locals; ++i) {
    call.numbered[i] = numbered_[i + 1];
    call.given |= std::uint64_t{given_[i + 1]} << i;
    numbered_[i + 1] = i < arguments.size() ? arguments[i] : 0;
    given_[i + 1] = !std::isnan(numbered_[i + 1]);
  }
  return true;
}

void Parameters::leave_call() {
  const Call& call = calls_.back();
  for (std::size_t i = 0; i < call.locals; ++i) {
    numbered_[i + 1] = call.numbered[i];
    given_[i + 1] = (call.given >> i) & 1u;
  }
  for (; hidden_.size() > call.hidden; hidden_.pop_back()) *hidden_.back().name = hidden_.back().before;
  calls_.pop_back();
}

void Parameters::load(std::span<const NumberedValue> values) {
  for (const auto& [number, value] : values) {
    set(number, number == current_system && value < 1 ? 1 : value);
    loaded_.push_back(number);
  }
}

std::vector<NumberedValue> Parameters::persistent() const {
  std::vector<NumberedValue> values;
  auto loaded = loaded_.begin();
  for (int number = 1; number <= last; ++number) {
    const bool was_loaded = loaded != loaded_.end() && *loaded == number;
    if (was_loaded) ++loaded;
    if (was_loaded || (is_offset(number) && given_[static_cast<std::size_t>(number)])) {
      values.push_back({number, numbered_[static_cast<std::size_t>(number)]});
    }
  }
  return values;
}

base::AxisVector Parameters::axes(int first) const {
  base::AxisVector value;
  for (std::size_t i = 0; i < base::axis_count; ++i) value[i] = numbered_[static_cast<std::size_t>(first) + i];
  return value;
}

void Parameters::set_axes(int first, const base::AxisVector& value) {
  for (std::size_t i = 0; i < base::axis_count; ++i) set(first + static_cast<int>(i), value[i]);
}

CoordinateSystem Parameters::system(int number) const {
  if (number > numbered_systems) {
    const auto found = further_systems_.find(number);
    return found == further_systems_.end() ? CoordinateSystem{} : found->second;
  }
  const int first = first_of_system(number);
  return {axes(first), numbered_[static_cast<std::size_t>(first) + base::axis_count]};
}

void Parameters::set_system(int number, const CoordinateSystem& system) {
  if (number > numbered_systems) {
    further_systems_[number] = system;
    return;
  }
  const int first = first_of_system(number);
  set_axes(first, system.origin);
  set(first + static_cast<int>(base::axis_count), system.rotation);
}

}  // namespace leadscrew::gcode
