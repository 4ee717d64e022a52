// A queue in block memory, whose oldest word is seen in a register: one word in and one out at every clock.
//
// A word is seen from the second clock after its push on.
module command_fifo #(
    parameter int WIDTH = 8,
    parameter int DEPTH_LOG2 = 4  // ≥ 1
) (
    input  logic                clk,
    input  logic                rst,
    input  logic                push,  // refused where full
    input  logic [   WIDTH-1:0] in,
    input  logic                take,  // of the word that is seen
    output logic [   WIDTH-1:0] out,
    output logic                valid,
    output logic                full,
    output logic [DEPTH_LOG2:0] level
);
  logic [WIDTH-1:0] memory[1 << DEPTH_LOG2];
  logic [DEPTH_LOG2-1:0] from, to, from_next;
  logic [DEPTH_LOG2:0] level_taken;
  logic pushes, takes;

  assign full = level[DEPTH_LOG2];
  assign pushes = push & ~full;
  assign takes = take & valid;
  assign from_next = takes ? from + 1'b1 : from;
  assign level_taken = takes ? level - 1'b1 : level;

  always_ff @(posedge clk) begin
    if (pushes) memory[to] <= in;
    out <= memory[from_next];
  end

  always_ff @(posedge clk) begin
    if (rst) begin
      from  <= '0;
      to    <= '0;
      level <= '0;
      valid <= 1'b0;
    end else begin
      from  <= from_next;
      if (pushes) to <= to + 1'b1;
      level <= pushes ? level_taken + 1'b1 : level_taken;
      valid <= level_taken != '0;
    end
  end
endmodule
