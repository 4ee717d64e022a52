// koren_hw.sv on the vectors of test_paper_vectors.cpp, in any simulator; as arc_vectors.sv.
module koren_vectors #(
    parameter int Q = 300,
    parameter int Q0 = 10,
    parameter bit STRICT = 1'b0
);
  `include "rows.svh"
  logic load, is_arc, grows_1, command, x_pulse, y_pulse, busy;
  logic [13:0] f;
  logic [16:0] begin_1, begin_2, y1, y2;
  logic [17:0] steps_x, steps_y, r1, r2, left_x, left_y;
  koren_hw #(
      .Q(Q),
      .Q0(Q0),
      .STRICT(STRICT)
  ) core (
      .clk(clk), .rst(rst), .load(load), .is_arc(is_arc), .grows_1(grows_1), .f(f), .begin_1(begin_1),
      .begin_2(begin_2), .steps_x(steps_x), .steps_y(steps_y), .command(command), .x_pulse(x_pulse),
      .y_pulse(y_pulse), .busy(busy), .y1(y1), .y2(y2), .r1(r1), .r2(r2), .left_x(left_x), .left_y(left_y)
  );

  integer in_load, in_arc, in_grows, in_f, in_1, in_2, in_x, in_y, x, z, to_busy, to_1, to_2;
  initial begin
    open_rows;
    got = 14;
    while (got == 14) begin
      got = $fscanf(rows, "%d %d %d %d %d %d %d %d %d %d %d %d %d %d", in_rst, in_load, in_arc, in_grows, in_f, in_1, in_2,
                    in_x, in_y, x, z, to_busy, to_1, to_2);
      if (got == 14) begin
        rst = in_rst[0];
        load = in_load[0];
        is_arc = in_arc[0];
        grows_1 = in_grows[0];
        f = in_f[13:0];
        begin_1 = in_1[16:0];
        begin_2 = in_2[16:0];
        steps_x = in_x[17:0];
        steps_y = in_y[17:0];
        pass_clock;
        if (x_pulse !== x[0] || y_pulse !== z[0]) fail(1);
        if (busy !== to_busy[0]) fail(2);
        if (to_busy[0] && (y1 != to_1 || y2 != to_2)) fail(3);
      end
    end
    finish;
  end
endmodule
