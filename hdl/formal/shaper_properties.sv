// step_shaper.sv with any times and any wishes: each output tells that a promise is broken.
module shaper_properties #(
    parameter int TIME_WIDTH = 2
) (
    input logic clk,
    input logic [4*TIME_WIDTH-1:0] any_times,
    input logic moves,
    input logic any_backward,
    input logic wants,
    output logic fails_length,     // a pulse is as long as set
    output logic fails_space,      // and as far from the next one, at least
    output logic fails_setup,      // the direction stands before a rising edge
    output logic fails_hold,       // and after a falling one
    output logic fails_direction,  // a pulse has the direction of its step
    output logic fails_step        // a pulse is there where a step was taken, and nowhere else
);
  localparam int LONG = TIME_WIDTH + 2;

  logic begun, step, direction, ready, rests, take, rst;
  logic [TIME_WIDTH-1:0] length, space, setup, hold, length_1;
  assign rst  = ~begun;
  assign take = wants & moves & ready;
  assign length_1 = length == '0 ? TIME_WIDTH'(1) : length;
  initial begun = 1'b0;

  step_shaper #(
      .TIME_WIDTH(TIME_WIDTH)
  ) shaper (
      .clk(clk),
      .rst(rst),
      .length(length),
      .space(space),
      .setup(setup),
      .hold(hold),
      .moves(moves),
      .backward(any_backward),
      .take(take),
      .ready(ready),
      .step(step),
      .direction(direction),
      .rests(rests)
  );

  // Clocks, saturated: this clock is the so many-th since …; `was_…`: of the clock before
  logic was_step, was_direction, was_taken, was_backward;
  logic [LONG-1:0] high, low, steady;  // … the rising edge, the falling edge, the change of direction
  logic rises, falls;
  assign rises = step & ~was_step;
  assign falls = ~step & was_step;

  always_ff @(posedge clk) begin
    begun <= 1'b1;
    if (rst) begin
      {length, space, setup, hold} <= any_times;
      {was_step, was_direction, was_taken, was_backward} <= '0;
      high <= '0;
      low <= '1;
      steady <= '1;
    end else begin
      was_step <= step;
      was_direction <= direction;
      was_taken <= take;
      was_backward <= any_backward;
      high <= ~step ? '0 : (rises | was_taken ? LONG'(1) : (&high ? high : high + 1'b1));
      low <= step ? '0 : (&low ? low : low + 1'b1);
      steady <= direction != was_direction ? LONG'(1) : (&steady ? steady : steady + 1'b1);
    end
  end

  logic [LONG-1:0] steady_now;
  assign steady_now = direction != was_direction ? '0 : steady;

  // A further step without space between: the pulse goes on, each of its steps as long as set.
  assign fails_length = begun & ((falls & high != LONG'(length_1)) | (was_taken & was_step & high != LONG'(length_1))
                                 | (step & ~was_taken & high >= LONG'(length_1) & was_step));
  assign fails_space = begun & (space != '0 & was_taken & was_step | rises & low < LONG'(space));
  assign fails_setup = begun & was_taken & steady_now < LONG'(setup);
  assign fails_hold = begun & direction != was_direction & (hold != '0 & was_step | low < LONG'(hold));
  assign fails_direction = begun & was_taken & direction != was_backward;
  assign fails_step = begun & (was_taken & ~step | rises & ~was_taken | rests & step);
endmodule
