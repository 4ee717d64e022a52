// Step and direction signals of one axis, never faster than its drive allows.
//
//   step       ____/‾‾‾‾‾‾\______________/‾‾‾‾          length: from a rising edge to the falling one
//                  |length| space …                     space:  from there to the next rising one
//   direction  ____|______|_hold_/‾‾setup‾‾‾‾‾          hold: from the falling edge to a change, setup: from there
//                                                       to the rising edge
// A step is taken at a clock with `want` and `ready`, and begins at that clock's edge. The direction changes as soon as
// an axis is to move the other way, wanted or not. All times in clocks; a length of 0 is one of 1.
module step_shaper #(
    parameter int TIME_WIDTH = 16
) (
    input  logic                  clk,
    input  logic                  rst,
    input  logic [TIME_WIDTH-1:0] length,
    input  logic [TIME_WIDTH-1:0] space,
    input  logic [TIME_WIDTH-1:0] setup,
    input  logic [TIME_WIDTH-1:0] hold,
    input  logic                  moves,     // the axis takes part in what goes on
    input  logic                  backward,  // this way
    input  logic                  take,      // a step; only where ready
    output logic                  ready,
    output logic                  step,
    output logic                  direction,
    output logic                  rests      // no time is running
);
  logic [TIME_WIDTH-1:0] high_left, low_left, hold_left, setup_left;
  logic high_ends, spaced, held, turns;

  // What a counter holds where so many clocks are to pass, this one included.
  function automatic [TIME_WIDTH-1:0] less_one(input logic [TIME_WIDTH-1:0] clocks);
    less_one = clocks == '0 ? '0 : clocks - 1'b1;
  endfunction

  assign high_ends = step & high_left == '0;
  assign spaced = step ? high_ends & space == '0 : low_left == '0;
  assign held = step ? high_ends & hold == '0 : hold_left == '0;
  assign turns = moves & backward != direction & held;
  assign ready = spaced & (backward == direction ? setup_left == '0 : held & setup == '0);
  assign rests = ~step & low_left == '0 & hold_left == '0 & setup_left == '0;

  always_ff @(posedge clk) begin
    if (rst) begin
      step <= 1'b0;
      direction <= 1'b0;
      high_left <= '0;
      low_left <= '0;
      hold_left <= '0;
      setup_left <= '0;
    end else begin
      if (take) begin
        step <= 1'b1;
        high_left <= less_one(length);
      end else if (high_ends) begin
        step <= 1'b0;
      end else if (step) begin
        high_left <= high_left - 1'b1;
      end

      if (high_ends) low_left <= less_one(space);
      else if (low_left != '0) low_left <= low_left - 1'b1;

      if (high_ends) hold_left <= less_one(hold);
      else if (hold_left != '0) hold_left <= hold_left - 1'b1;

      if (turns) begin
        direction <= backward;
        setup_left <= less_one(setup);
      end else if (setup_left != '0) begin
        setup_left <= setup_left - 1'b1;
      end
    end
  end
endmodule
