// Between Wishbone B4 and the registers: a standard slave, which answers in the third clock; stall_o makes it one for pipelined
// masters too (B4, 5.2). A wrong address, or a write that is refused, is answered by err_o in place of ack_o. A master that
// ends its cycle before the answer gets none, and a write that it has begun may have been made.
module wishbone (
    input logic clk,
    input logic rst,  // synchronous

    input  logic        cyc_i,
    input  logic        stb_i,
    input  logic        we_i,
    input  logic [ 8:2] adr_i,
    input  logic [31:0] dat_i,
    input  logic [ 3:0] sel_i,
    output logic [31:0] dat_o,
    output logic        ack_o,
    output logic        err_o,
    output logic        stall_o,

    output logic        reg_write,
    output logic        reg_read,
    output logic [ 8:2] reg_address,
    output logic [31:0] reg_write_data,
    output logic [ 3:0] reg_write_strobe,
    input  logic [31:0] reg_read_data,
    input  logic        reg_error
);

  logic asks, answers, done;  // one clock each: access, its data, the answer
  logic begins;
  assign begins = cyc_i && stb_i && !asks && !answers && !done;
  assign stall_o = cyc_i && !(ack_o || err_o);

  always_ff @(posedge clk) begin
    asks <= begins;
    answers <= asks && cyc_i;
    done <= answers && cyc_i;
    reg_write <= begins && we_i;
    reg_read <= begins && !we_i;
    if (begins) begin
      reg_address <= adr_i;
      reg_write_data <= dat_i;
      reg_write_strobe <= sel_i;
    end
    ack_o <= answers && cyc_i && !reg_error;
    err_o <= answers && cyc_i && reg_error;
    if (answers) dat_o <= reg_error ? 32'd0 : reg_read_data;
    if (rst) begin
      asks <= 1'b0;
      answers <= 1'b0;
      done <= 1'b0;
      reg_write <= 1'b0;
      reg_read <= 1'b0;
      ack_o <= 1'b0;
      err_o <= 1'b0;
    end
  end
endmodule
