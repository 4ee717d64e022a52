// What the three interpolators by search have in common: position and deviation along an arc about the origin.
//
//   F = x² + z² − R²       a step of X by ±1 adds 1 ± 2x to it, a step of Z by ±1 adds 1 ± 2z, both add both
//
// The method is another module's: it sees F and what the steps along the tangent add, and says which axes step.
//
// Where it ends: in the quadrant of the end, the axis that is fast near the end says when the path is beside it, or past
// it; the last steps, at most two, then go straight to the end. Equality with the end alone would miss ends that are not
// on the path, for coordinates are rounded.
//
// FIRST_QUADRANT: only 0 ≤ x, 0 ≤ z and counterclockwise, as in the paper; nothing is refused.

module arc_search #(
    parameter int WIDTH = 16,  // of the signed coordinates, bits: 4 … 31
    parameter bit FIRST_QUADRANT = 1'b0
) (
    input  logic                    clk,
    input  logic                    rst,        // synchronous
    input  logic signed [WIDTH-1:0] start_x,    // BLU
    input  logic signed [WIDTH-1:0] start_z,
    input  logic signed [WIDTH-1:0] end_x,
    input  logic signed [WIDTH-1:0] end_z,
    input  logic                    clockwise,
    input  logic                    syn,        // takes all these and starts
    input  logic                    step_x,     // the method's choice at this clock, along the tangent
    input  logic                    step_z,
    output logic signed [WIDTH-1:0] x,
    output logic signed [WIDTH-1:0] z,
    output logic signed [WIDTH+2:0] f,          // F
    output logic signed [WIDTH+2:0] by_x,       // what a step of X adds to F, 1 ± 2x
    output logic signed [WIDTH+2:0] by_z,
    output logic                    x_shrinks,  // |x| does and |z| grows; else the other way round
    output logic                    x_pulse,    // X has just stepped
    output logic                    z_pulse,
    output logic                    x_up,       // in the sense of increasing x
    output logic                    z_up,
    output logic                    busy,       // from the start to the last pulse
    output logic                    refused     // what syn took is no arc; until the next syn
);
  logic running, is_past, is_clockwise, x_ends;
  logic [2:0] borders;
  logic signed [WIDTH-1:0] last_x, last_z;  // the end

  // ---- This step.
  logic tangent_x_up, tangent_z_up, goes_x_up, goes_z_up, goes_x, goes_z;

  if (FIRST_QUADRANT) begin : g_here_first
    assign tangent_x_up = 1'b0;
    assign tangent_z_up = 1'b1;
    assign x_shrinks = 1'b1;
  end else begin : g_here
    logic [1:0] unused_quadrant;
    arc_quadrant #(.WIDTH(WIDTH)) here (
        .x(x), .z(z), .clockwise(is_clockwise), .quadrant(unused_quadrant), .x_up(tangent_x_up), .z_up(tangent_z_up),
        .x_shrinks(x_shrinks));
  end

  assign goes_x_up = is_past ? last_x > x : tangent_x_up;
  assign goes_z_up = is_past ? last_z > z : tangent_z_up;
  assign goes_x = running && (is_past ? last_x != x : step_x);
  assign goes_z = running && (is_past ? last_z != z : step_z);
  assign by_x = goes_x_up ? {{2{x[WIDTH-1]}}, x, 1'b1} : (WIDTH + 3)'(1) - {{2{x[WIDTH-1]}}, x, 1'b0};
  assign by_z = goes_z_up ? {{2{z[WIDTH-1]}}, z, 1'b1} : (WIDTH + 3)'(1) - {{2{z[WIDTH-1]}}, z, 1'b0};

  // ---- Where it leads, or where syn begins.
  logic signed [WIDTH-1:0] next_x, next_z, to_x, to_z;
  logic crosses, next_clockwise, next_x_up, next_z_up, next_x_ends, next_is_past, is_refused;
  logic [2:0] next_borders, all_borders;

  assign next_x = syn ? start_x : goes_x ? (goes_x_up ? x + WIDTH'(1) : x - WIDTH'(1)) : x;
  assign next_z = syn ? start_z : goes_z ? (goes_z_up ? z + WIDTH'(1) : z - WIDTH'(1)) : z;
  assign to_x = syn ? end_x : last_x;
  assign to_z = syn ? end_z : last_z;
  assign crosses = !is_past && (x_shrinks ? next_x == '0 : next_z == '0);

  if (FIRST_QUADRANT) begin : g_next_first
    assign is_refused = 1'b0;
    assign next_clockwise = 1'b0;
    assign next_x_up = 1'b0;
    assign next_z_up = 1'b1;
    assign all_borders = 3'd0;
    assign next_borders = 3'd0;
    logic unused;
    assign unused = &{1'b0, clockwise, is_clockwise, borders, all_borders, next_clockwise};
  end else begin : g_next
    logic [1:0] unused_quadrant;
    logic unused_shrinks;
    logic [WIDTH-1:0] unused_radius;
    arc_entry #(.WIDTH(WIDTH)) entry (
        .start_x(start_x), .start_z(start_z), .end_x(end_x), .end_z(end_z), .clockwise(clockwise),
        .refused(is_refused), .borders(all_borders), .radius(unused_radius));
    arc_quadrant #(.WIDTH(WIDTH)) there (
        .x(next_x), .z(next_z), .clockwise(next_clockwise), .quadrant(unused_quadrant), .x_up(next_x_up),
        .z_up(next_z_up), .x_shrinks(unused_shrinks));
    assign next_clockwise = syn ? clockwise : is_clockwise;
    assign next_borders = syn ? all_borders : borders - {2'b00, crosses && borders != 3'd0};
  end

  // ---- Is the fast axis beside the end, or past it? Near the end X is fast where |z| ≥ |x|.
  logic signed [WIDTH-1:0] fast, fast_to;
  logic [WIDTH-1:0] end_x_size, end_z_size;
  logic fast_up;

  assign end_x_size = end_x[WIDTH-1] ? -end_x : end_x;
  assign end_z_size = end_z[WIDTH-1] ? -end_z : end_z;
  assign next_x_ends = syn ? end_z_size >= end_x_size : x_ends;
  assign fast = next_x_ends ? next_x : next_z;
  assign fast_to = next_x_ends ? to_x : to_z;
  assign fast_up = next_x_ends ? next_x_up : next_z_up;
  assign next_is_past =
      (!syn && is_past) ||
      (next_borders == 3'd0 && ((FIRST_QUADRANT && !syn && crosses) || (fast_up ? fast_to <= fast : fast_to >= fast)));

  always_ff @(posedge clk) begin
    x_pulse <= goes_x && !syn && !rst;
    z_pulse <= goes_z && !syn && !rst;
    if (rst) begin
      running <= 1'b0;
      busy <= 1'b0;
      refused <= 1'b0;
    end else begin
      busy <= syn ? !is_refused : running;
      if (syn) refused <= is_refused;
      if (syn) running <= !is_refused;
      else if (next_is_past && next_x == last_x && next_z == last_z) running <= 1'b0;
    end
    if (syn || running) begin
      x <= next_x;
      z <= next_z;
      borders <= next_borders;
      is_past <= next_is_past;
      x_up <= goes_x_up;
      z_up <= goes_z_up;
      f <= syn ? '0 : f + (goes_x ? by_x : '0) + (goes_z ? by_z : '0);
    end
    if (syn) begin
      last_x <= end_x;
      last_z <= end_z;
      x_ends <= next_x_ends;
      is_clockwise <= clockwise;
    end
  end
endmodule
