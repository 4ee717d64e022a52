// The quadrant in which a motion about the origin goes on from a place, and the tangent there.
//
//   ccw          Z          A place on an axis belongs to the quadrant that the motion enters there. In each quadrant
//            1   |   0      one coordinate shrinks to 0 while the other grows.
//        --------+-------- X
//            2   |   3

module arc_quadrant #(
    parameter int WIDTH = 16  // of the coordinates, bits
) (
    input  logic signed [WIDTH-1:0] x,         // BLU
    input  logic signed [WIDTH-1:0] z,
    input  logic                    clockwise,
    output logic [1:0]              quadrant,
    output logic                    x_up,      // the tangent: X increases
    output logic                    z_up,
    output logic                    x_shrinks  // |x| does, |z| grows; else the other way round
);
  logic x_zero, z_zero, x_below, z_below;

  assign x_zero = x == '0;
  assign z_zero = z == '0;
  assign x_below = x[WIDTH-1];
  assign z_below = z[WIDTH-1];

  always_comb begin
    if (!clockwise) begin
      if (!x_below && !x_zero && !z_below) quadrant = 2'd0;
      else if ((x_below || x_zero) && !z_below && !z_zero) quadrant = 2'd1;
      else if (x_below && (z_below || z_zero)) quadrant = 2'd2;
      else quadrant = 2'd3;
    end else begin
      if (!x_below && !z_below && !z_zero) quadrant = 2'd0;
      else if (x_below && !z_below) quadrant = 2'd1;
      else if ((x_below || x_zero) && z_below) quadrant = 2'd2;
      else quadrant = 2'd3;
    end
  end

  assign x_up = quadrant[1] ^ clockwise;
  assign z_up = ~(quadrant[1] ^ quadrant[0]) ^ clockwise;
  assign x_shrinks = ~(quadrant[0] ^ clockwise);
endmodule
