// Between AXI4-Lite and the registers: one access at a time. Addresses in bytes, of which the lowest two do not count. A wrong
// address, or a write that is refused, is SLVERR. Where a read and a write wait at the same time, they take turns.
module axi4_lite (
    input logic clk,
    input logic rst,  // synchronous

    input  logic        awvalid,
    output logic        awready,
    input  logic [ 8:0] awaddr,
    input  logic        wvalid,
    output logic        wready,
    input  logic [31:0] wdata,
    input  logic [ 3:0] wstrb,
    output logic        bvalid,
    input  logic        bready,
    output logic [ 1:0] bresp,
    input  logic        arvalid,
    output logic        arready,
    input  logic [ 8:0] araddr,
    output logic        rvalid,
    input  logic        rready,
    output logic [31:0] rdata,
    output logic [ 1:0] rresp,

    output logic        reg_write,
    output logic        reg_read,
    output logic [ 8:2] reg_address,
    output logic [31:0] reg_write_data,
    output logic [ 3:0] reg_write_strobe,
    input  logic [31:0] reg_read_data,
    input  logic        reg_error
);

  localparam logic [1:0] OKAY = 2'b00, SLVERR = 2'b10;

  // What happens: an access in one clock, its data in the next one, then the answer until it is taken.
  logic asks, answers, is_write, last_was_write, may_write, may_read;
  assign may_write = awvalid && wvalid;
  assign may_read = arvalid;

  logic idle, takes_write, takes_read;
  assign idle = !asks && !answers && !bvalid && !rvalid;
  assign takes_write = idle && may_write && !(may_read && last_was_write);
  assign takes_read = idle && may_read && !takes_write;

  assign awready = takes_write;
  assign wready = takes_write;
  assign arready = takes_read;

  always_ff @(posedge clk) begin
    asks <= takes_write || takes_read;
    answers <= asks;
    reg_write <= takes_write;
    reg_read <= takes_read;
    if (takes_write || takes_read) begin
      is_write <= takes_write;
      last_was_write <= takes_write;
      reg_address <= takes_write ? awaddr[8:2] : araddr[8:2];
      reg_write_data <= wdata;
      reg_write_strobe <= wstrb;
    end
    if (answers) begin
      bvalid <= is_write;
      rvalid <= !is_write;
      bresp <= reg_error ? SLVERR : OKAY;
      rresp <= reg_error ? SLVERR : OKAY;
      rdata <= reg_error ? 32'd0 : reg_read_data;
    end
    if (bvalid && bready) bvalid <= 1'b0;
    if (rvalid && rready) rvalid <= 1'b0;
    if (rst) begin
      asks <= 1'b0;
      answers <= 1'b0;
      reg_write <= 1'b0;
      reg_read <= 1'b0;
      bvalid <= 1'b0;
      rvalid <= 1'b0;
      last_was_write <= 1'b0;
    end
  end

  logic unused;
  assign unused = &{1'b0, awaddr[1:0], araddr[1:0]};
endmodule
