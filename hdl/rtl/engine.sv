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
    input  logic [          FEED_WIDTH:0] next_feed_straight,
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
  logic [FEED_WIDTH:0] sum, feed, feed_straight, word;
  logic [  4*AXES-1:0] source;
  logic [    AXES-2:0] steps;  // of each unit
  logic [         1:0] curve;
  logic [    AXES-1:0] drives;
  logic overflow, counts, over, straight;

  assign steps_left = running ? left[WIDTH-1:0] + WIDTH'(2) : '0;
  assign overflow = sum[FEED_WIDTH];
  assign straight = overflow & ~steps[0];
  assign counts = overflow | dwell;
  assign over = counts & left[WIDTH];
  assign finished = running & over;
  assign take = go & next_valid & over;

  // What is added for the next tick. Both conditions are of registers' topmost bits, so that the adder does not wait long.
  always_comb begin
    word = straight ? feed_straight : feed;
    if (over) word = straight ? next_feed_straight : next_feed;
  end

  // At rest: the last tick of a dwell that does not end.
  always_ff @(posedge clk) begin
    if (rst | abort_now) begin
      sum <= '0;
      running <= 1'b0;
      dwell <= 1'b1;
      left[WIDTH] <= 1'b1;
    end else if (go) begin
      sum <= {1'b0, sum[FEED_WIDTH-1:0]};
      if (next_valid | ~over) sum <= {1'b0, sum[FEED_WIDTH-1:0]} + word;
      if (over) begin
        running <= next_valid;
        dwell <= next_dwell | ~next_valid;
        if (next_valid) left <= next_left;
      end else if (counts) begin
        left <= left - 1'b1;
      end
    end
    if (rst) begin
      source <= '0;
      backward <= '0;
    end else if (take) begin
      source <= next_source;
      backward <= next_backward;
    end
    if (take) begin
      curve <= next_curve;
      feed <= next_feed;
      feed_straight <= next_feed_straight;
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
