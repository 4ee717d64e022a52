// Steps of one axis counted, signed, and a copy of the count when it is asked for.
module position_counter #(
    parameter int WIDTH = 32
) (
    input  logic             clk,
    input  logic             rst,
    input  logic             step,
    input  logic             backward,   // with step: −1
    input  logic             set,        // takes set_value; a step of the same clock is added to it
    input  logic [WIDTH-1:0] set_value,
    input  logic             latch,      // copies the position before this clock's step
    output logic [WIDTH-1:0] position,
    output logic [WIDTH-1:0] latched
);
  logic [WIDTH-1:0] change;

  assign change = {{(WIDTH - 1) {step & backward}}, step};

  always_ff @(posedge clk) begin
    if (rst) position <= '0;
    else position <= (set ? set_value : position) + change;
    if (rst) latched <= '0;
    else if (latch) latched <= position;
  end
endmodule
