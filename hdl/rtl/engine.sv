// Feed DDA and second-order Bresenham: decides at each tick which axes step. motion_core.sv says what a command is.
//
// All of a tick is known from registers at its beginning: `sum` holds the remainder with the word of this tick added, so
// that its topmost bit is the overflow, and the decisions E are those of the step that this overflow would make.
module engine #(
    parameter int AXES = 2,
    parameter int WIDTH = 24,
    parameter int FEED_WIDTH = 32
) (
    input logic clk,
    input logic rst,
    input logic go,     // this tick passes
    input logic abort_now,  // the running command is dropped

    // The next command; taken at a clock with `take`
    input  logic                          next_valid,
    input  logic                          next_dwell,
    input  logic [               WIDTH:0] next_left,  // count − 2, two's complement: its sign is that of the last step
    input  logic [          FEED_WIDTH:0] next_feed,  // 0 for a dwell
    input  logic [          FEED_WIDTH:0] next_feed_diagonal,
    input  logic [            4*AXES-1:0] next_source,
    input  logic [              AXES-1:0] next_backward,
    input  logic [                   1:0] next_curve,
    input  logic [(AXES-1)*(WIDTH+2)-1:0] next_decision,
    input  logic [(AXES-1)*(WIDTH+2)-1:0] next_straight,
    input  logic [(AXES-1)*(WIDTH+2)-1:0] next_diagonal,
    output logic                          take,

    output logic            running,
    output logic            finished,  // the last step, or tick of a dwell, if this tick passes
    output logic [WIDTH-1:0] steps_left,  // of the running command
    output logic [AXES-1:0] wanted,    // steps of this tick, if it passes
    output logic [AXES-1:0] backward,  // their sense
    output logic [AXES-1:0] moves      // axes that the running command has
);
  logic                dwell;
  logic [     WIDTH:0] left;  // steps from here to the end, less 2: negative at the last one
  logic [FEED_WIDTH:0] sum, feed, feed_diagonal, word;
  logic [  4*AXES-1:0] source;
  logic [    AXES-2:0] steps;  // of each unit
  logic [         1:0] curve;
  logic [    AXES-1:0] drives;
  logic overflow, counts, feeding, goes_diagonal, after_diagonal;

  assign steps_left = running ? left[WIDTH-1:0] + WIDTH'(2) : '0;
  assign overflow = sum[FEED_WIDTH];
  assign goes_diagonal = steps[0];
  assign counts   = overflow | dwell;
  assign finished = running & counts & left[WIDTH];
  assign take     = go & next_valid & (finished | ~running);
  assign feeding  = take | (running & ~finished);

  always_comb begin
    word = (overflow ? goes_diagonal : after_diagonal) ? feed_diagonal : feed;
    if (finished | ~running) word = next_feed;
  end

  always_ff @(posedge clk) begin
    if (rst | abort_now) begin
      sum <= '0;
      running <= 1'b0;
      dwell <= 1'b0;
    end else if (go) begin
      sum <= {1'b0, sum[FEED_WIDTH-1:0]};
      if (feeding) sum <= {1'b0, sum[FEED_WIDTH-1:0]} + word;
      running <= feeding;
      if (finished | ~running) dwell <= next_dwell & next_valid;
    end
    if (rst) begin
      source <= '0;
      backward <= '0;
    end else if (take) begin
      source <= next_source;
      backward <= next_backward;
    end
    if (take) begin
      left <= next_left;
      curve <= next_curve;
      feed <= next_feed;
      feed_diagonal <= next_feed_diagonal;
      after_diagonal <= 1'b0;
    end else if (go & counts) begin
      left <= left - 1'b1;
      after_diagonal <= goes_diagonal;
    end
  end

  genvar u, i;
  generate
    for (u = 0; u < AXES - 1; u = u + 1) begin : unit
      decision_unit #(
          .WIDTH(WIDTH + 2),
          .SECOND_ORDER(u == 0 ? 1 : 0)
      ) decides (
          .clk(clk),
          .load(take),
          .go(go & overflow),
          .curve(curve),
          .next_decision(next_decision[u*(WIDTH+2)+:WIDTH+2]),
          .next_straight(next_straight[u*(WIDTH+2)+:WIDTH+2]),
          .next_diagonal(next_diagonal[u*(WIDTH+2)+:WIDTH+2]),
          .steps(steps[u])
      );
    end
    for (i = 0; i < AXES; i = i + 1) begin : axis
      logic [AXES-2:0] follows;
      for (u = 0; u < AXES - 1; u = u + 1) begin : of_unit
        assign follows[u] = source[4*i+:4] == u + 2;
      end
      assign drives[i] = source[4*i+:4] == 4'd1;
      assign wanted[i] = running & overflow & (drives[i] | (|(steps & follows)));
      assign moves[i]  = running & source[4*i+:4] != 4'd0;
    end
  endgenerate
endmodule
