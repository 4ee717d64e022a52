#pragma once
// The parameters of a program: numbered ones, some of which keep the offsets between program and machine, and named
// ones (LinuxCNC manual, "Parameters" and "Subroutines").
//
// Each call of a subroutine has the first thirty numbers, and the names that do not begin with an underscore, for
// itself. Names are bound shallowly: the value in force stands beside the name, and what it hid is kept on a trail that
// the end of the call unwinds. So a call costs thirty numbers and what the subroutine sets, however many names there
// are, and reading a name is one search.

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/gcode/frame.hpp>
#include <leadscrew/gcode/parameter_file.hpp>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace leadscrew::gcode {

/// The parameters of a program: numbers 1 … 5601, and names. Offsets (5161 … 5390) are kept in mm and degrees, the
/// units of the machine, as LinuxCNC keeps them.
class Parameters {
 public:
  static constexpr int last = 5601;
  static constexpr int locals = 30;        ///< #1 … #30 are a call's own
  static constexpr int macro_locals = 33;  ///< #1 … #33 are those of a macro of Fanuc's
  static constexpr std::size_t most_names = 10'000;
  static constexpr std::size_t most_calls = 1000;            ///< one within another
  static constexpr std::size_t most_hidden_names = 100'000;  ///< by the calls under way, together
  static constexpr int g28_home = 5161;                      ///< first of nine: axes X Y Z A B C U V W
  static constexpr int g30_home = 5181;
  static constexpr int external_offset = 5201;  ///< Fanuc's, of nine axes: added to all coordinate systems
  static constexpr int g92_active = 5210;
  static constexpr int g92_shift = 5211;
  static constexpr int current_system = 5220;
  static constexpr int first_system = 5221;  ///< of the numbers of G54 … G59.3
  static constexpr int last_system = 5390;
  static constexpr int numbered_systems = 9;
  static constexpr int current_position = 5420;
  static constexpr int shows_debug = 5599;  ///< whether (DEBUG,…) says anything

  Parameters();
  Parameters(const Parameters&) = delete;  // the trail points into the names
  Parameters& operator=(const Parameters&) = delete;

  /// std::nullopt where no value was ever given, or is not now; 1 ≤ number ≤ last.
  std::optional<double> get(int number) const;
  bool has(int number) const { return given_[static_cast<std::size_t>(number)]; }  ///< a value; 1 ≤ number ≤ last
  double value_or(int number, double otherwise) const {
    const auto i = static_cast<std::size_t>(number);
    return given_[i] ? numbered_[i] : otherwise;
  }
  void set(int number, double value);
  void unset(int number);  ///< makes it vacant (Fanuc)
  std::optional<double> get(const std::string& name) const;
  /// False where there are too many names.
  bool set(const std::string& name, double value);

  /// A subroutine begins: #1 … #30, or up to #33 where there are so many arguments, become the arguments, those
  /// without one 0 (LinuxCNC), those whose argument is not a number without value (Fanuc's vacant arguments). No local
  /// name has a value. False, and nothing changes, where most_calls are under way.
  bool enter_call(std::span<const double> arguments);
  /// The subroutine entered last ends: its numbers and the local names are the caller's again. One must be under way.
  void leave_call();
  std::size_t calls() const { return calls_.size(); }  ///< under way

  /// What the subroutine that ended last has returned, #<_value>; none where it returned nothing or one has begun since.
  std::optional<double> returned() const { return returned_; }
  void set_returned(std::optional<double> value) { returned_ = value; }

  /// Whether a parameter keeps a place or an offset.
  static bool is_offset(int number) { return g28_home <= number && number <= last_system; }

  /// Sets what a parameter file has said; each number stays persistent.
  void load(std::span<const NumberedValue> values);
  /// What a parameter file keeps, by ascending number: the offsets, and what load() was given.
  std::vector<NumberedValue> persistent() const;

  base::AxisVector axes(int first) const;
  void set_axes(int first, const base::AxisVector& value);
  /// 1 … 9: G54 … G59.3, which have numbers; 10 … 309: G54.1 P1 … P300, which have none.
  CoordinateSystem system(int number) const;
  void set_system(int number, const CoordinateSystem& system);

 private:
  /// A value of a name. A local one holds in the call whose depth it has.
  struct Binding {
    double value = 0;
    std::int32_t depth = -1;  ///< of the call that set it; −1 where none has
  };
  struct Hidden {
    Binding* name;
    Binding before;
  };
  struct Call {
    std::array<double, macro_locals> numbered;
    std::uint64_t given;  ///< bits of those of the numbered that have a value
    std::size_t locals;   ///< how many numbers are the call's own
    std::size_t hidden;   ///< how much of the trail is its callers'
  };

  static bool is_global(const std::string& name) { return name.starts_with('_'); }
  std::int32_t depth() const { return static_cast<std::int32_t>(calls_.size()); }

  std::array<double, last + 1> numbered_{};
  std::bitset<last + 1> given_;
  std::unordered_map<std::string, Binding> named_;  // its elements stay where they are
  std::unordered_map<int, CoordinateSystem> further_systems_;
  std::vector<int> loaded_;  // numbers, ascending
  std::vector<Call> calls_;
  std::vector<Hidden> hidden_;
  std::optional<double> returned_;
};

}  // namespace leadscrew::gcode
