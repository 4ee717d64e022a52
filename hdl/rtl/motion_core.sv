// Commands of motion in, step and direction signals out, for AXES axes.
//
//   push ─▶ command FIFO ─▶ engine (feed DDA, second-order Bresenham) ─▶ step shapers ─▶ step, direction
//                              hold, abort, watchdog                └──▶ position counters, latches
//
// A command makes `count` steps of its driving axis, one at each overflow of the feed DDA. All other axes follow it by
// units of decision: a unit makes a step where its decision E is not negative, and then
//
//                          E            S (straight)      D (diagonal)
//   no step of the unit    E + S        S + 2c            D + 2c
//   a step                 E + D        S + 2c            D + 4c          c = −1, 0, 1: command_curve
//
// Unit 0 has this second order, for the octants of circles; the units 1 … AXES − 2 have c = 0. Each axis has a source:
// 0 it stands, 1 it drives (a step at every overflow), 2 + u it follows unit u; and a sense, 1 for steps of −1.
//
// Line by the counts m_i of the axes, q the greatest of them (pulse::LinearBresenham; with more axes the linear DDA of
// capacity q preloaded with ⌊(q − 1)/2⌋): count q, c = 0; an axis with m_i = q drives; each other with m_i > 0 has a unit
//
//   E = 2 m_i − q − 1      S = 2 m_i      D = 2 m_i − 2 q
//
// for after k overflows an axis is to have made ⌊(2 k m_i + q − 1)/2q⌋ steps: E is 2 k m_i − (2 n + 1) q − 1 for k the
// next overflow and n the steps made.
//
// Octant of a circle about the origin (pulse::CircularSearch of least error): in a quadrant the coordinate of magnitude
// s shrinks while that of magnitude g grows; F = s² + g² − R², a = 1 − 2 s is what a step of s adds to F, b = 2 g + 1
// one of g. Both step rather than g alone where |F + a + b| < |F + b|, that is 2 (F + b) + a ≥ 0; both rather than s
// alone where 2 (F + a) + b < 0. The sums are odd, so that halves of them decide:
//
//   g drives (g ≤ s):   E = F + b + (a − 1)/2      S =   b + 2     D =   a + b + 3      c =  1
//   s drives (s ≤ g):   E = −F − a − (b + 1)/2     S = −(a + 2)    D = −(a + b + 3)     c = −1
//
// hdl/driver/octants.hpp derives where the octants of an arc begin and end and gives their commands. All other axes
// stand, or follow lines of count steps by units 1 … (source 3 …).
//
// Dwell: command_dwell, count ticks without a step; the feed DDA keeps its remainder.
//
// Feed: at every tick (each `prescale` + 1 clocks) command_feed is added to a remainder of FEED_WIDTH bits, its overflow
// is a step of the driving axis; 2^FEED_WIDTH, an overflow at every tick, is the greatest word. Between commands the
// remainder stays, and no tick is lost. At the tick of a step of the driving axis without one of unit 0
// command_feed_straight is added instead, which gives the next step a start before what follows a diagonal one: so the
// remainder is length of path, and hdl/driver/octants.hpp chooses both words for an even speed along it. The same word
// twice leaves all steps evenly spaced. At the last step of a command both are the next one's.
//
// Where an axis is to step sooner than its drive's times allow, all axes wait for it: the path stays, and
// error[ERROR_STRETCHED] tells. With step_length 1 and all other times 0 nothing ever waits (for models: two steps at
// adjacent clocks are one pulse then; see step_strobe).
module motion_core #(
    parameter int AXES = 3,             // 2 … 7
    parameter int WIDTH = 24,           // of counts: commands of up to 2^WIDTH − 1 steps, circles of R < 2^(WIDTH−1)
    parameter int FEED_WIDTH = 40,      // of the feed DDA's remainder
    parameter int DEPTH_LOG2 = 4,       // the FIFO holds 2^DEPTH_LOG2 commands
    parameter int POSITION_WIDTH = 32,
    parameter int TIME_WIDTH = 16
) (
    input logic clk,
    input logic rst,  // synchronous

    // Command to be queued: all of it at the clock of command_push. Refused, with an error, where the FIFO is full or
    // count is 0.
    input logic                            command_push,
    input logic [               WIDTH-1:0] command_count,          // steps of the driving axis; ticks of a dwell
    input logic                            command_dwell,
    input logic                            command_final,          // motion may end here: no underflow behind it
    input logic [                    15:0] command_tag,            // anything; seen at running_tag
    input logic [            FEED_WIDTH:0] command_feed,           // steps/tick · 2^FEED_WIDTH, up to 2^FEED_WIDTH
    input logic [            FEED_WIDTH:0] command_feed_straight,  // in its place at a step without unit 0
    input logic [              4*AXES-1:0] command_source,         // four bits an axis: 0, 1, 2 + u
    input logic [                AXES-1:0] command_backward,       // steps of −1
    input logic [                     1:0] command_curve,          // c, two's complement: 00, 01, 11
    input logic [(AXES-1)*(WIDTH+2)-1:0]   command_decision,       // E of each unit, signed, unit 0 lowest
    input logic [(AXES-1)*(WIDTH+2)-1:0]   command_straight,       // S
    input logic [(AXES-1)*(WIDTH+2)-1:0]   command_diagonal,       // D

    output logic [DEPTH_LOG2:0] fifo_level,  // commands queued, the running one not counted
    output logic                fifo_full,
    input  logic [DEPTH_LOG2:0] watermark,
    output logic                fifo_low,    // fifo_level ≤ watermark

    // Of the whole core
    input  logic        hold,             // level: no tick passes, no step begins from the next clock on
    input  logic        abort_now,            // one clock: queue and running command are dropped; pulses end in full
    input  logic [15:0] prescale,         // clocks a tick, less 1
    input  logic [31:0] watchdog_period,  // clocks from kick to kick, at most; 0: no watchdog
    input  logic        watchdog_kick,    // one clock
    output logic        running,          // a command is being made
    output logic        busy,             // running, or commands are queued, or a step pulse is not over
    output logic [15:0] running_tag,      // of the running command, or of the last one
    output logic [31:0] commands_done,    // since reset, modulo 2^32
    output logic [WIDTH-1:0] steps_left,  // of the running command

    // Sticky errors, until cleared. A watchdog that has expired holds the core until its error is cleared.
    //   0 overflow: a push was refused for the FIFO was full; what is queued stays
    //   1 underflow: a command that is not final ended and none was queued; the core waits for the next one
    //   2 watchdog
    //   3 stretched: steps waited for a drive's times
    //   4 empty: a push was refused for its count is 0
    output logic [4:0] error,
    input  logic [4:0] error_clear,  // one clock
    // Levels: 0 fifo_low, 1 not busy, 2 any error, 3 latched
    input  logic [3:0] interrupt_enable,
    output logic       irq,

    // Position of each axis, steps, signed; counted where a step is decided, up to its direction set-up before its edge.
    output logic [AXES*POSITION_WIDTH-1:0] position,
    input  logic [AXES-1:0]                position_set,        // one clock: these become position_set_value
    input  logic [POSITION_WIDTH-1:0]      position_set_value,
    input  logic                           latch,               // one clock: copies all positions
    input  logic                           probe,               // a pin: at its rising edge, if probe_enable, the same
    input  logic                           probe_enable,
    output logic [AXES*POSITION_WIDTH-1:0] latched_position,
    output logic                           latched,             // since latch_clear
    input  logic                           latch_clear,         // one clock

    // Times of each axis' drive, clocks: step high at least so long (≥ 1; 0 counts as 1), low at least so long; the
    // direction stands so long before a step's rising edge, and so long after its falling edge.
    input logic [AXES*TIME_WIDTH-1:0] step_length,
    input logic [AXES*TIME_WIDTH-1:0] step_space,
    input logic [AXES*TIME_WIDTH-1:0] direction_setup,
    input logic [AXES*TIME_WIDTH-1:0] direction_hold,

    // For one clock where a step is decided: what pulse/ calls a pulse, at its tick
    output logic [AXES-1:0] step_strobe,
    output logic [AXES-1:0] step_backward,
    // To the drives
    output logic [AXES-1:0] step,
    output logic [AXES-1:0] direction  // 1: backward
);
  localparam int UNITS = AXES - 1;
  localparam int UNIT_WIDTH = WIDTH + 2;
  localparam int COMMAND_WIDTH =
      3 * UNITS * UNIT_WIDTH + 2 + AXES + 4 * AXES + 2 * (FEED_WIDTH + 1) + 16 + 2 + WIDTH + 1;
  localparam int OVERFLOW = 0, UNDERFLOW = 1, WATCHDOG = 2, STRETCHED = 3, EMPTY = 4;

  // The queue
  logic [COMMAND_WIDTH-1:0] pushed, queued;
  logic [WIDTH:0] pushed_left, next_left;
  logic [FEED_WIDTH:0] pushed_feed, pushed_feed_straight, next_feed, next_feed_straight;
  logic [15:0] next_tag;
  logic [4*AXES-1:0] next_source;
  logic [AXES-1:0] next_backward;
  logic [1:0] next_curve;
  logic [UNITS*UNIT_WIDTH-1:0] next_decision, next_straight, next_diagonal;
  logic is_empty, next_valid, next_dwell, next_final, take;

  assign is_empty = command_count == '0;
  assign pushed_left = {1'b0, command_count} - (WIDTH + 1)'(2);
  assign pushed_feed = command_dwell ? '0 : command_feed;
  assign pushed_feed_straight = command_dwell ? '0 : command_feed_straight;
  assign pushed = {
    command_decision, command_straight, command_diagonal, command_curve, command_backward, command_source,
    pushed_feed, pushed_feed_straight, command_tag, command_final, command_dwell, pushed_left
  };
  assign {
    next_decision, next_straight, next_diagonal, next_curve, next_backward, next_source,
    next_feed, next_feed_straight, next_tag, next_final, next_dwell, next_left
  } = queued;

  command_fifo #(
      .WIDTH(COMMAND_WIDTH),
      .DEPTH_LOG2(DEPTH_LOG2)
  ) fifo (
      .clk(clk),
      .rst(rst | abort_now),
      .push(command_push & ~is_empty),
      .in(pushed),
      .take(take),
      .out(queued),
      .valid(next_valid),
      .full(fifo_full),
      .level(fifo_level)
  );
  assign fifo_low = fifo_level <= watermark;

  // The tick: it waits for the drives, and passes late then.
  logic [15:0] prescaled;
  logic [AXES-1:0] wanted, backward, moves, ready, rests;
  logic due, held, waits, go, finished, is_final;

  assign due = prescaled == '0;
  assign held = hold | error[WATCHDOG] | abort_now;
  assign waits = |(wanted & ~ready);
  assign go = due & ~held & ~waits;

  always_ff @(posedge clk) begin
    if (rst) prescaled <= '0;
    else if (go) prescaled <= prescale;
    else if (~due & ~hold) prescaled <= prescaled - 1'b1;
  end

  engine #(
      .AXES(AXES),
      .WIDTH(WIDTH),
      .FEED_WIDTH(FEED_WIDTH)
  ) decides (
      .clk(clk),
      .rst(rst),
      .go(go),
      .abort_now(abort_now),
      .next_valid(next_valid),
      .next_dwell(next_dwell),
      .next_left(next_left),
      .next_feed(next_feed),
      .next_feed_straight(next_feed_straight),
      .next_source(next_dwell ? '0 : next_source),
      .next_backward(next_backward),
      .next_curve(next_curve),
      .next_decision(next_decision),
      .next_straight(next_straight),
      .next_diagonal(next_diagonal),
      .take(take),
      .running(running),
      .finished(finished),
      .steps_left(steps_left),
      .wanted(wanted),
      .backward(backward),
      .moves(moves)
  );
  assign step_strobe = wanted & {AXES{go}};
  assign step_backward = backward;

  // What host and watchdog see
  logic [31:0] since_kick;
  logic [4:0] error_now;
  logic probe_seen, probe_was, probe_is, latches;

  assign busy = running | fifo_level != '0 | ~(&rests);
  assign irq = |(interrupt_enable & {latched, |error, ~busy, fifo_low});

  assign error_now[OVERFLOW] = command_push & ~is_empty & fifo_full;
  assign error_now[UNDERFLOW] = go & finished & ~next_valid & ~is_final;
  assign error_now[WATCHDOG] = watchdog_period != '0 & since_kick >= watchdog_period;
  assign error_now[STRETCHED] = due & ~held & waits;
  assign error_now[EMPTY] = command_push & is_empty;

  always_ff @(posedge clk) begin
    if (rst) begin
      error <= '0;
      since_kick <= '0;
      running_tag <= '0;
      commands_done <= '0;
      is_final <= 1'b0;
    end else begin
      error <= (error & ~error_clear) | error_now;
      since_kick <= watchdog_kick | error_clear[WATCHDOG] | watchdog_period == '0 ? '0 : since_kick + {31'b0, ~error[WATCHDOG]};
      if (take) running_tag <= next_tag;
      if (take) is_final <= next_final;
      if (go & finished) commands_done <= commands_done + 1'b1;
    end
  end

  // Positions, copied by the host or at the probe's edge; two flip-flops take the pin to this clock.
  assign latches = latch | (probe_enable & probe_is & ~probe_was);

  always_ff @(posedge clk) begin
    if (rst) begin
      {probe_seen, probe_is, probe_was} <= '0;
      latched <= 1'b0;
    end else begin
      {probe_seen, probe_is, probe_was} <= {probe, probe_seen, probe_is};
      latched <= latches | (latched & ~latch_clear);
    end
  end

  genvar i;
  generate
    for (i = 0; i < AXES; i = i + 1) begin : axis
      position_counter #(
          .WIDTH(POSITION_WIDTH)
      ) counter (
          .clk(clk),
          .rst(rst),
          .step(step_strobe[i]),
          .backward(backward[i]),
          .set(position_set[i]),
          .set_value(position_set_value),
          .latch(latches),
          .position(position[i*POSITION_WIDTH+:POSITION_WIDTH]),
          .latched(latched_position[i*POSITION_WIDTH+:POSITION_WIDTH])
      );
      step_shaper #(
          .TIME_WIDTH(TIME_WIDTH)
      ) shaper (
          .clk(clk),
          .rst(rst),
          .length(step_length[i*TIME_WIDTH+:TIME_WIDTH]),
          .space(step_space[i*TIME_WIDTH+:TIME_WIDTH]),
          .setup(direction_setup[i*TIME_WIDTH+:TIME_WIDTH]),
          .hold(direction_hold[i*TIME_WIDTH+:TIME_WIDTH]),
          .moves(moves[i]),
          .backward(backward[i]),
          .take(step_strobe[i]),
          .ready(ready[i]),
          .step(step[i]),
          .direction(direction[i]),
          .rests(rests[i])
      );
    end
  endgenerate
endmodule
