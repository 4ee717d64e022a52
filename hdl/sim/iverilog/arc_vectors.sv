// A circular core of rtl/paper on the vectors of test_paper_vectors.cpp, in any simulator. CORE is the module's name, given
// by -D; +rows=FILE has a line a clock: what goes in, and what is seen after it. Prints `passed`, or what differs.
module arc_vectors #(
    parameter int WIDTH = 6
);
  `include "rows.svh"
  logic syn, cw, x_pulse, z_pulse, x_up, z_up, busy, err;
  logic signed [WIDTH-1:0] x0, z0, x1, z1, x, z;
  `CORE #(
      .WIDTH(WIDTH)
  ) core (
      .clk(clk), .rst(rst), .Start_X0(x0), .Start_Z0(z0), .End_X1(x1), .End_Z1(z1), .Cw(cw), .Syn(syn),
      .X_Pwm_Out(x_pulse), .Z_Pwm_Out(z_pulse), .X_Dir(x_up), .Z_Dir(z_up), .Busy(busy), .Err(err), .Val_x(x),
      .Val_z(z)
  );

  integer in_syn, in_cw, in_x0, in_z0, in_x1, in_z1, dx, dz, to_busy, to_err, to_x, to_z;
  initial begin
    open_rows;
    got = 13;
    while (got == 13) begin
      got = $fscanf(rows, "%d %d %d %d %d %d %d %d %d %d %d %d %d", in_rst, in_syn, in_cw, in_x0, in_z0, in_x1, in_z1,
                    dx, dz, to_busy, to_err, to_x, to_z);
      if (got == 13) begin
        rst = in_rst[0];
        syn = in_syn[0];
        cw = in_cw[0];
        x0 = in_x0[WIDTH-1:0];
        z0 = in_z0[WIDTH-1:0];
        x1 = in_x1[WIDTH-1:0];
        z1 = in_z1[WIDTH-1:0];
        pass_clock;
        if (x_pulse !== (dx != 0) || z_pulse !== (dz != 0)) fail(1);
        if ((x_pulse && x_up !== (dx > 0)) || (z_pulse && z_up !== (dz > 0))) fail(2);
        if (busy !== to_busy[0] || err !== to_err[0]) fail(3);
        if (to_busy[0] && (x != to_x || z != to_z)) fail(4);
      end
    end
    finish;
  end
endmodule
