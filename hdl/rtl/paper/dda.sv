// Circular interpolation by two digital integrators (the paper's DDA, eqs. 6 to 8), each fed with the coordinate of the
// other axis as it was before the clock:
//
//   Sum_X ← Sum_X + |z|, a pulse of X where it reaches R        Sum_Z ← Sum_Z + |x|, a pulse of Z where it reaches R
//
// At the start of every quadrant the sum of the axis whose coordinate of the other one is smaller, which lags, is half full
// ("half-loading"), the other one empty. An axis that has made the steps of its quadrant stands still until the other one
// has; should the other one's integrand be 0 by then, for R is rounded, it steps at every clock.
//
// FIRST_QUADRANT: only 0 ≤ x, 0 ≤ z, counterclockwise and from (R, 0): R is the start's x, and there is no root.

module dda #(
    parameter int WIDTH = 16,            // of the signed coordinates, bits: 4 … 31
    parameter bit FIRST_QUADRANT = 1'b0
) (
    input  logic                    clk,
    input  logic                    rst,        // synchronous
    input  logic signed [WIDTH-1:0] Start_X0,   // BLU, about the centre of the circle
    input  logic signed [WIDTH-1:0] Start_Z0,
    input  logic signed [WIDTH-1:0] End_X1,     // the start again: a full circle
    input  logic signed [WIDTH-1:0] End_Z1,
    input  logic                    Cw,         // clockwise, seen with X to the right and Z up
    input  logic                    Syn,        // takes all these at this clock and starts
    output logic                    X_Pwm_Out,  // high for one clock: X has stepped
    output logic                    Z_Pwm_Out,
    output logic                    X_Dir,      // with the pulse: 1 where x has increased
    output logic                    Z_Dir,
    output logic                    Busy,       // from Syn to the last pulse
    output logic                    Err,        // what Syn took is no arc (arc_entry.sv); until the next Syn
    output logic signed [WIDTH-1:0] Val_x,      // where it is
    output logic signed [WIDTH-1:0] Val_z,
    output logic [WIDTH:0]          Sum_X,      // remainders
    output logic [WIDTH:0]          Sum_Z
);
  logic running, is_clockwise, x_up, z_up;
  logic [2:0] borders;                       // still to be passed
  logic [WIDTH-1:0] radius;
  logic signed [WIDTH-1:0] end_x, end_z;     // of the arc
  logic signed [WIDTH-1:0] target_x, target_z;  // of this quadrant

  // ---- The integrators.
  logic [WIDTH-1:0] x_size, z_size;
  logic [WIDTH:0] sum_x, sum_z;
  logic x_left, z_left, x_overflows, z_overflows, goes_x, goes_z;

  assign x_size = Val_x[WIDTH-1] ? -Val_x : Val_x;
  assign z_size = Val_z[WIDTH-1] ? -Val_z : Val_z;
  assign x_left = Val_x != target_x;
  assign z_left = Val_z != target_z;
  assign sum_x = Sum_X + {1'b0, z_size};
  assign sum_z = Sum_Z + {1'b0, x_size};
  assign x_overflows = sum_x >= {1'b0, radius};
  assign z_overflows = sum_z >= {1'b0, radius};
  assign goes_x = running && x_left && (x_overflows || (!z_left && z_size == '0));
  assign goes_z = running && z_left && (z_overflows || (!x_left && x_size == '0));

  // ---- Where this clock leads: within the quadrant, into the next one, or where Syn begins.
  logic signed [WIDTH-1:0] next_x, next_z, to_x, to_z;
  logic [WIDTH-1:0] next_radius;
  logic [2:0] next_borders, all_borders;
  logic arrives, enters, is_refused, x_lags;

  assign next_x = Syn ? Start_X0 : goes_x ? (x_up ? Val_x + WIDTH'(1) : Val_x - WIDTH'(1)) : Val_x;
  assign next_z = Syn ? Start_Z0 : goes_z ? (z_up ? Val_z + WIDTH'(1) : Val_z - WIDTH'(1)) : Val_z;
  assign arrives = next_x == target_x && next_z == target_z;
  assign enters = Syn || (arrives && borders != 3'd0);
  assign next_borders = Syn ? all_borders : borders - 3'd1;

  if (FIRST_QUADRANT) begin : g_first
    assign is_refused = 1'b0;
    assign all_borders = 3'd0;
    assign next_radius = Start_X0;
    assign to_x = End_X1;
    assign to_z = End_Z1;
    assign x_lags = 1'b1;
    assign x_up = 1'b0;
    assign z_up = 1'b1;
    logic unused;
    assign unused = &{1'b0, Cw, is_clockwise, end_x, end_z};
  end else begin : g_all
    logic [1:0] next_quadrant, border;
    logic [WIDTH-1:0] root, next_x_size, next_z_size;
    logic next_clockwise, unused_x_up, unused_z_up, unused_shrinks;

    arc_entry #(.WIDTH(WIDTH)) entry (
        .start_x(Start_X0), .start_z(Start_Z0), .end_x(End_X1), .end_z(End_Z1), .clockwise(Cw), .refused(is_refused),
        .borders(all_borders), .radius(root));
    arc_quadrant #(.WIDTH(WIDTH)) there (
        .x(next_x), .z(next_z), .clockwise(next_clockwise), .quadrant(next_quadrant), 
        .x_up(unused_x_up), .z_up(unused_z_up), .x_shrinks(unused_shrinks));
    assign next_clockwise = Syn ? Cw : is_clockwise;
    assign next_radius = Syn ? root : radius;

    // The border where the circle leaves a quadrant: 0 at +Z, 1 at −X, 2 at −Z, 3 at +X.
    assign border = next_clockwise ? next_quadrant - 2'd1 : next_quadrant;
    assign to_x = next_borders == 3'd0 ? (Syn ? End_X1 : end_x)
                                       : !border[0] ? '0 : border[1] ? next_radius : -next_radius;
    assign to_z = next_borders == 3'd0 ? (Syn ? End_Z1 : end_z)
                                       : border[0] ? '0 : border[1] ? -next_radius : next_radius;
    assign next_x_size = next_x[WIDTH-1] ? -next_x : next_x;
    assign next_z_size = next_z[WIDTH-1] ? -next_z : next_z;
    assign x_lags = next_z_size < next_x_size;
    always_ff @(posedge clk)
      if (enters) begin
        x_up <= to_x > next_x;
        z_up <= to_z > next_z;
      end
  end

  always_ff @(posedge clk) begin
    X_Pwm_Out <= goes_x && !Syn && !rst;
    Z_Pwm_Out <= goes_z && !Syn && !rst;
    X_Dir <= x_up;
    Z_Dir <= z_up;
    if (rst) begin
      running <= 1'b0;
      Busy <= 1'b0;
      Err <= 1'b0;
    end else begin
      Busy <= Syn ? !is_refused : running;
      if (Syn) Err <= is_refused;
      if (Syn) running <= !is_refused;
      else if (arrives && borders == 3'd0) running <= 1'b0;
    end
    if (Syn) begin
      is_clockwise <= Cw;
      end_x <= End_X1;
      end_z <= End_Z1;
      radius <= next_radius;
    end
    if (Syn || running) begin
      Val_x <= next_x;
      Val_z <= next_z;
      if (enters) begin
        borders <= next_borders;
        target_x <= to_x;
        target_z <= to_z;
        Sum_X <= x_lags ? {1'b0, next_radius} >> 1 : '0;
        Sum_Z <= x_lags ? '0 : {1'b0, next_radius} >> 1;
      end else begin
        if (x_left) Sum_X <= sum_x - (x_overflows ? {1'b0, radius} : '0);
        if (z_left) Sum_Z <= sum_z - (z_overflows ? {1'b0, radius} : '0);
      end
    end
  end
endmodule
