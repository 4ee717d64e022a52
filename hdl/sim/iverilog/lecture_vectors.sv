// lecture_dda.sv on the vectors of test_paper_vectors.cpp, in any simulator; as arc_vectors.sv.
module lecture_vectors #(
    parameter int M = 5,
    parameter int N = 7
);
  `include "rows.svh"
  logic load, x_down, y_down, command, x_pulse, y_pulse, busy;
  logic encoder_x, encoder_x_down, encoder_y, encoder_y_down;
  logic [M-1:0] S;
  logic [N-1:0] dx, dy;
  logic [N:0] pulses_x, pulses_y, pdc_x, pdc_y;
  logic signed [N-1:0] udc_x, udc_y;
  lecture_dda #(
      .M(M),
      .N(N)
  ) core (
      .clk(clk), .rst(rst), .load(load), .S(S), .dx(dx), .dy(dy), .pulses_x(pulses_x), .pulses_y(pulses_y),
      .x_down(x_down), .y_down(y_down), .encoder_x(encoder_x), .encoder_x_down(encoder_x_down),
      .encoder_y(encoder_y), .encoder_y_down(encoder_y_down), .command(command), .x_pulse(x_pulse),
      .y_pulse(y_pulse), .busy(busy), .pdc_x(pdc_x), .pdc_y(pdc_y), .udc_x(udc_x), .udc_y(udc_y)
  );

  integer in_load, in_s, in_dx, in_dy, in_px, in_py, in_down, in_encoders, x, y, to_x, to_y, u, v;
  initial begin
    open_rows;
    got = 15;
    while (got == 15) begin
      got = $fscanf(rows, "%d %d %d %d %d %d %d %d %d %d %d %d %d %d %d", in_rst, in_load, in_s, in_dx, in_dy, in_px, in_py, in_down,
                    in_encoders, x, y, to_x, to_y, u, v);
      if (got == 15) begin
        rst = in_rst[0];
        load = in_load[0];
        S = in_s[M-1:0];
        dx = in_dx[N-1:0];
        dy = in_dy[N-1:0];
        pulses_x = in_px[N:0];
        pulses_y = in_py[N:0];
        {y_down, x_down} = in_down[1:0];
        {encoder_y_down, encoder_y, encoder_x_down, encoder_x} = in_encoders[3:0];
        pass_clock;
        if (x_pulse !== x[0] || y_pulse !== y[0]) fail(1);
        if (pdc_x != to_x || pdc_y != to_y || busy !== (to_x + to_y > 0)) fail(2);
        if (udc_x != u || udc_y != v) fail(3);
      end
    end
    finish;
  end
endmodule
