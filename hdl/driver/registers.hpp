#pragma once
// Made by script/registers of hdl/registers/registers.toml: do not edit.
// Offsets in bytes; fields by their lowest bit (_bit) and, where they have more than one, their width (_bits).

#include <cstdint>

namespace leadscrew::driver::registers {

inline constexpr std::uint32_t identification_value = 0x4C534352;
inline constexpr std::uint32_t version_value = 0x00020000;

/// 0x4C534352, "LSCR".
inline constexpr std::uint32_t identification = 0x000;

/// Of this register map: the major version in bits 31:16, the minor one in 15:0. A driver refuses another major
/// version.
inline constexpr std::uint32_t version = 0x004;

/// How the core was built.
inline constexpr std::uint32_t parameters = 0x008;
/// How many axes there are, 2 … 7.
inline constexpr int parameters_axes_bit = 0;
inline constexpr int parameters_axes_bits = 4;
/// The FIFO holds 2^DEPTH_LOG2 commands.
inline constexpr int parameters_depth_log2_bit = 4;
inline constexpr int parameters_depth_log2_bits = 4;
/// Of counts, bits.
inline constexpr int parameters_width_bit = 8;
inline constexpr int parameters_width_bits = 6;
/// Of the feed DDA's remainder, bits.
inline constexpr int parameters_feed_width_bit = 16;
inline constexpr int parameters_feed_width_bits = 6;
/// Of the coordinates of the circular interpolators, bits; 0: there are none.
inline constexpr int parameters_paper_width_bit = 24;
inline constexpr int parameters_paper_width_bits = 6;

/// Levels.
inline constexpr std::uint32_t control = 0x00C;
/// 1: no tick passes, no step begins from the next clock on. 0: motion goes on, no step is lost.
inline constexpr int control_hold_bit = 0;
/// 1: a rising edge of the pin `probe` latches all positions.
inline constexpr int control_probe_enable_bit = 1;

/// Each 1 that is written acts once.
inline constexpr std::uint32_t trigger = 0x010;
/// The queue and the running command are dropped; a pulse that has begun ends in full.
inline constexpr int trigger_abort_bit = 0;
/// Copies all positions to LATCHED.
inline constexpr int trigger_latch_bit = 1;
/// Makes STATUS.LATCHED 0.
inline constexpr int trigger_latch_clear_bit = 2;
/// Begins WATCHDOG_PERIOD anew.
inline constexpr int trigger_watchdog_kick_bit = 3;

/// Now.
inline constexpr std::uint32_t status = 0x014;
/// A command is being made.
inline constexpr int status_running_bit = 0;
/// RUNNING, or commands are queued, or a step pulse is not over.
inline constexpr int status_busy_bit = 1;
/// A command that is pushed now is refused.
inline constexpr int status_fifo_full_bit = 2;
/// FIFO_LEVEL ≤ WATERMARK.
inline constexpr int status_fifo_low_bit = 3;
/// Positions were latched since LATCH_CLEAR.
inline constexpr int status_latched_bit = 4;
/// The interrupt line.
inline constexpr int status_interrupt_bit = 5;
/// By CONTROL.HOLD or by the pin `hold_pin`.
inline constexpr int status_held_bit = 6;
/// Tag of the running command, or of the last one.
inline constexpr int status_tag_bit = 16;
inline constexpr int status_tag_bits = 16;

/// Sticky: each bit stays 1 until a 1 is written to it. None of these loses a command that is queued.
inline constexpr std::uint32_t error = 0x018;
/// A command was pushed while the FIFO was full: it was refused.
inline constexpr int error_overflow_bit = 0;
/// A command that is not final ended and none was queued: motion waits for the next one.
inline constexpr int error_underflow_bit = 1;
/// The watchdog was not kicked in time: motion is held until this bit is cleared.
inline constexpr int error_watchdog_bit = 2;
/// Steps waited for a drive's times: the path stays, the feed was less.
inline constexpr int error_stretched_bit = 3;
/// A command with a count of 0 was pushed: it was refused.
inline constexpr int error_empty_bit = 4;
/// An access to an address without a register: nothing changed; reads give 0.
inline constexpr int error_address_bit = 5;
/// A write of less than 32 bits, or of a register that is only read: nothing changed.
inline constexpr int error_partial_bit = 6;

/// The interrupt line is high while a level below is 1 and enabled.
inline constexpr std::uint32_t interrupt_enable = 0x01C;
/// FIFO_LEVEL ≤ WATERMARK.
inline constexpr int interrupt_enable_fifo_low_bit = 0;
/// Not BUSY.
inline constexpr int interrupt_enable_idle_bit = 1;
/// Any bit of ERROR.
inline constexpr int interrupt_enable_error_bit = 2;
/// STATUS.LATCHED.
inline constexpr int interrupt_enable_latched_bit = 3;

/// The levels of INTERRUPT_ENABLE, whether enabled or not.
inline constexpr std::uint32_t interrupt_status = 0x020;

/// Commands that are queued; the running one is not counted.
inline constexpr std::uint32_t fifo_level = 0x024;

/// See STATUS.FIFO_LOW.
inline constexpr std::uint32_t watermark = 0x028;

/// Clocks a tick of the feed, less 1; bits 15:0.
inline constexpr std::uint32_t prescale = 0x02C;

/// Clocks from one WATCHDOG_KICK to the next, at most; 0: no watchdog.
inline constexpr std::uint32_t watchdog_period = 0x030;

/// Since reset, modulo 2^32.
inline constexpr std::uint32_t commands_done = 0x034;

/// Of the running command.
inline constexpr std::uint32_t steps_left = 0x038;

/// Which axis STEP_TIMES and DIRECTION_TIMES are of, 0 … AXES − 1; bits 2:0.
inline constexpr std::uint32_t axis = 0x03C;

/// Clocks, of the selected axis.
inline constexpr std::uint32_t step_times = 0x040;
/// Step high, at least; 0 counts as 1.
inline constexpr int step_times_length_bit = 0;
inline constexpr int step_times_length_bits = 16;
/// Step low, at least.
inline constexpr int step_times_space_bit = 16;
inline constexpr int step_times_space_bits = 16;

/// Clocks, of the selected axis.
inline constexpr std::uint32_t direction_times = 0x044;
/// The direction stands so long before a step's rising edge.
inline constexpr int direction_times_setup_bit = 0;
inline constexpr int direction_times_setup_bits = 16;
/// And so long after its falling edge.
inline constexpr int direction_times_hold_bit = 16;
inline constexpr int direction_times_hold_bits = 16;

/// For POSITION_SET.
inline constexpr std::uint32_t position_value = 0x048;

/// A 1 in bit i: the position of axis i becomes POSITION_VALUE.
inline constexpr std::uint32_t position_set = 0x04C;

/// Steps of each axis, signed: counted where a step is decided. Those of axes that there are not read 0.
inline constexpr std::uint32_t position = 0x080;
inline constexpr int position_count = 7;
inline constexpr std::uint32_t position_stride = 4;

/// All positions at the same clock, when they were last latched.
inline constexpr std::uint32_t latched = 0x0A0;
inline constexpr int latched_count = 7;
inline constexpr std::uint32_t latched_stride = 4;

/// Steps of the driving axis; ticks of a dwell.
inline constexpr std::uint32_t command_count = 0x050;

/// Bits 31:0 of the feed word: steps a tick · 2^FEED_WIDTH.
inline constexpr std::uint32_t command_feed_low = 0x054;

/// Bits FEED_WIDTH:32 of it.
inline constexpr std::uint32_t command_feed_high = 0x058;

/// The word that is added at a step of the driving axis without unit 0: more for an even speed along the path, the
/// same for even steps.
inline constexpr std::uint32_t command_straight_feed_low = 0x05C;

/// Bits FEED_WIDTH:32 of it.
inline constexpr std::uint32_t command_straight_feed_high = 0x060;

/// Four bits an axis, axis 0 lowest: 0 it stands, 1 it drives, 2 + u it follows unit u.
inline constexpr std::uint32_t command_source = 0x064;

/// A write queues the command.
inline constexpr std::uint32_t command_push = 0x068;
/// A bit for each axis, 1 for steps of −1.
inline constexpr int command_push_backward_bit = 0;
inline constexpr int command_push_backward_bits = 7;
/// c of unit 0: 0 for lines; 1 or −1 (3) for octants of circles.
inline constexpr int command_push_curve_bit = 8;
inline constexpr int command_push_curve_bits = 2;
/// No steps.
inline constexpr int command_push_dwell_bit = 10;
/// Motion may end behind this command: that is no underflow.
inline constexpr int command_push_final_bit = 11;
/// Anything; STATUS.TAG shows it while the command runs.
inline constexpr int command_push_tag_bit = 16;
inline constexpr int command_push_tag_bits = 16;

/// E of each unit, signed.
inline constexpr std::uint32_t unit_decision = 0x0C0;
inline constexpr int unit_decision_count = 6;
inline constexpr std::uint32_t unit_decision_stride = 12;

/// S of each unit, signed.
inline constexpr std::uint32_t unit_straight = 0x0C4;
inline constexpr int unit_straight_count = 6;
inline constexpr std::uint32_t unit_straight_stride = 12;

/// D of each unit, signed.
inline constexpr std::uint32_t unit_diagonal = 0x0C8;
inline constexpr int unit_diagonal_count = 6;
inline constexpr std::uint32_t unit_diagonal_stride = 12;

/// Start_X0, signed.
inline constexpr std::uint32_t paper_start_x = 0x140;

/// Start_Z0.
inline constexpr std::uint32_t paper_start_z = 0x144;

/// End_X1.
inline constexpr std::uint32_t paper_end_x = 0x148;

/// End_Z1.
inline constexpr std::uint32_t paper_end_z = 0x14C;

/// Which interpolator, and which way.
inline constexpr std::uint32_t paper_method = 0x150;
/// 0 point comparison, 1 DDA, 2 minimum error, 3 improved minimum error.
inline constexpr int paper_method_method_bit = 0;
inline constexpr int paper_method_method_bits = 2;
/// Cw.
inline constexpr int paper_method_clockwise_bit = 4;

/// Bit 0: Syn for one clock. Everything is latched then; while BUSY it is ignored.
inline constexpr std::uint32_t paper_start = 0x154;
/// Begin.
inline constexpr int paper_start_syn_bit = 0;

/// Of the selected interpolator.
inline constexpr std::uint32_t paper_status = 0x158;
/// Busy.
inline constexpr int paper_status_busy_bit = 0;
/// Err: the arc that was loaded is none.
inline constexpr int paper_status_refused_bit = 1;

/// Val_x, signed: where it is.
inline constexpr std::uint32_t paper_x = 0x15C;

/// Val_z.
inline constexpr std::uint32_t paper_z = 0x160;

}  // namespace leadscrew::driver::registers
