// What is to be known of an arc about the origin before its first step, from its coordinates, without a clock.
//
// This is the longest path of the cores, with five multipliers and an unrolled root: whoever needs a fast clock holds the
// coordinates for some clocks before Syn and tells the tools that the path has as many (a multicycle path). In the paper's
// system the processor writes them over its bus long before.
//
// An arc is refused where its start or its end is the origin; where its end is further from the circle through the start
// than half a BLU; and where the circle with 2 BLU about it does not fit the registers: R > 2^(WIDTH−1) − 3.

module arc_entry #(
    parameter int WIDTH = 16  // of the signed coordinates, bits: 4 … 31
) (
    input  logic signed [WIDTH-1:0] start_x,    // BLU
    input  logic signed [WIDTH-1:0] start_z,
    input  logic signed [WIDTH-1:0] end_x,
    input  logic signed [WIDTH-1:0] end_z,
    input  logic                    clockwise,
    output logic                    refused,
    output logic [2:0]              borders,    // of quadrants, that the arc passes: 0 … 4
    output logic [WIDTH-1:0]        radius      // rounded to the nearest, BLU
);
  logic [1:0] from, to;
  logic x_up, z_up, unused_x_up, unused_z_up, unused_first, unused_last;

  arc_quadrant #(.WIDTH(WIDTH)) first (
      .x(start_x), .z(start_z), .clockwise(clockwise), .quadrant(from), .x_up(x_up), .z_up(z_up),
      .x_shrinks(unused_first));
  // The end belongs to the quadrant that it closes: the one that a motion the other way would enter.
  arc_quadrant #(.WIDTH(WIDTH)) last (
      .x(end_x), .z(end_z), .clockwise(~clockwise), .quadrant(to), .x_up(unused_x_up), .z_up(unused_z_up),
      .x_shrinks(unused_last));

  // Within one quadrant an end is ahead where neither coordinate has to turn back. The start itself is not ahead: a
  // full circle.
  logic [1:0] passed;
  logic x_turns, z_turns, is_ahead;

  assign passed = clockwise ? from - to : to - from;
  assign x_turns = x_up ? end_x < start_x : end_x > start_x;
  assign z_turns = z_up ? end_z < start_z : end_z > start_z;
  assign is_ahead = !x_turns && !z_turns && (end_x != start_x || end_z != start_z);
  assign borders = passed == 2'd0 && !is_ahead ? 3'd4 : {1'b0, passed};

  // With m = R² and n = |end|², d = n − m: |√n − R| ≤ ½ where (4|d| ∓ 1)² ≤ 16m, minus for d > 0.
  localparam int SQUARE = 2 * WIDTH + 2;
  localparam int EXCESS = WIDTH + 3;
  localparam logic signed [SQUARE-1:0] GREATEST_RADIUS = (SQUARE)'(2) ** (WIDTH - 1) - (SQUARE)'(3);
  logic signed [SQUARE-1:0] x0, z0, x1, z1, squared_radius, d;
  logic [SQUARE-1:0] distance;
  logic [EXCESS-1:0] excess;
  logic [2*EXCESS-1:0] squared_excess;
  logic is_far, is_large, is_origin;

  assign x0 = SQUARE'(start_x);
  assign z0 = SQUARE'(start_z);
  assign x1 = SQUARE'(end_x);
  assign z1 = SQUARE'(end_z);
  assign squared_radius = x0 * x0 + z0 * z0;
  assign d = (x1 - x0) * (x1 + x0) + (z1 - z0) * (z1 + z0);
  assign distance = d < 0 ? -d : d;
  assign excess = {distance[EXCESS-3:0], 2'b00} + (d > 0 ? -EXCESS'(1) : EXCESS'(1));
  assign squared_excess = {{EXCESS{1'b0}}, excess} * {{EXCESS{1'b0}}, excess};
  assign is_far = distance[SQUARE-1:WIDTH] != '0 || squared_excess > {{(2 * EXCESS - SQUARE - 4) {1'b0}}, squared_radius, 4'b0000};
  assign is_large = squared_radius > GREATEST_RADIUS * GREATEST_RADIUS;
  assign is_origin = squared_radius == '0 || (end_x == '0 && end_z == '0);
  assign refused = is_far || is_large || is_origin;

  // The root, digit by digit: two bits of R² for each, and one digit behind the point that says how to round.
  logic [WIDTH+2:0] rest, tried;
  logic [WIDTH:0] digits;

  always_comb begin
    rest = '0;
    digits = '0;
    tried = '0;
    for (int pair = WIDTH - 1; pair >= -1; pair--) begin
      rest = (rest << 2) | (pair >= 0 ? (WIDTH + 3)'((squared_radius >> (2 * pair)) & SQUARE'(3)) : '0);
      tried = ((WIDTH + 3)'(digits) << 2) | 1;
      digits = digits << 1;
      if (rest >= tried) begin
        rest = rest - tried;
        digits = digits | 1;
      end
    end
    radius = WIDTH'((digits + (WIDTH + 1)'(1)) >> 1);
  end
endmodule
