// The up-down counter of a servo loop: commands less what the encoder has counted. At either end of its range it stays,
// as a counter that saturates does: such a pulse is lost.

module up_down_counter #(
    parameter int WIDTH = 16  // bits, the sign among them
) (
    input  logic                    clk,
    input  logic                    rst,           // synchronous: to 0
    input  logic                    command,       // a pulse of the interpolator at this clock
    input  logic                    command_down,  // it is negative
    input  logic                    encoder,       // a pulse of the encoder
    input  logic                    encoder_down,
    output logic signed [WIDTH-1:0] count
);
  localparam logic signed [WIDTH+1:0] GREATEST = {3'b000, {(WIDTH - 1) {1'b1}}};
  localparam logic signed [WIDTH+1:0] LEAST = ~GREATEST;
  logic signed [WIDTH+1:0] change, next;

  assign change = (command ? (command_down ? -(WIDTH + 2)'(1) : (WIDTH + 2)'(1)) : '0) -
                  (encoder ? (encoder_down ? -(WIDTH + 2)'(1) : (WIDTH + 2)'(1)) : '0);
  assign next = (WIDTH + 2)'(count) + change;

  always_ff @(posedge clk)
    if (rst) count <= '0;
    else if (next > GREATEST) count <= WIDTH'(GREATEST);
    else if (next < LEAST) count <= WIDTH'(LEAST);
    else count <= WIDTH'(next);
endmodule
