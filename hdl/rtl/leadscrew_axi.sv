// The motion core on AXI4-Lite: beside a processor on the same chip.
module leadscrew_axi #(
    parameter int AXES = 3,        // 2 … 7
    parameter int WIDTH = 24,      // 4 … 30: of counts, bits: circles of R < 2^(WIDTH−1)
    parameter int FEED_WIDTH = 40, // of the feed DDA's remainder: 33 … 62
    parameter int DEPTH_LOG2 = 4,  // the FIFO holds 2^DEPTH_LOG2 commands
    parameter int PAPER_WIDTH = 0  // 4 … 31: the paper's interpolators too, with coordinates of so many bits
) (
    input logic clk,  // ACLK
    input logic rst,  // synchronous; not ARESETn

    input  logic        awvalid,  // as bus/axi4_lite.sv has them
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

    input logic hold_pin,  // high: no tick of the feed passes; a button, or the other half of a machine
    input logic probe,     // a touch probe
    output logic irq,      // to the processor, by INTERRUPT_ENABLE
    output logic running,  // a command is being made

    // To the drives
    output logic [AXES-1:0] step,
    output logic [AXES-1:0] direction,  // 1: backward
    // For one clock where a step is decided, before any of the drives' times: for models and counters
    output logic [AXES-1:0] step_strobe,
    output logic [AXES-1:0] step_backward,
    // Of the paper's interpolator that is selected; low where there is none
    output logic X_Pwm_Out,
    output logic Z_Pwm_Out,
    output logic X_Dir,
    output logic Z_Dir
);
  logic reg_write, reg_read, reg_error;
  logic [8:2] reg_address;
  logic [31:0] reg_write_data, reg_read_data;
  logic [3:0] reg_write_strobe;

  axi4_lite bus (
      .clk(clk),
      .rst(rst),
      .awvalid(awvalid),
      .awready(awready),
      .awaddr(awaddr),
      .wvalid(wvalid),
      .wready(wready),
      .wdata(wdata),
      .wstrb(wstrb),
      .bvalid(bvalid),
      .bready(bready),
      .bresp(bresp),
      .arvalid(arvalid),
      .arready(arready),
      .araddr(araddr),
      .rvalid(rvalid),
      .rready(rready),
      .rdata(rdata),
      .rresp(rresp),
      .reg_write(reg_write),
      .reg_read(reg_read),
      .reg_address(reg_address),
      .reg_write_data(reg_write_data),
      .reg_write_strobe(reg_write_strobe),
      .reg_read_data(reg_read_data),
      .reg_error(reg_error)
  );

  leadscrew_core #(
      .AXES(AXES),
      .WIDTH(WIDTH),
      .FEED_WIDTH(FEED_WIDTH),
      .DEPTH_LOG2(DEPTH_LOG2),
      .PAPER_WIDTH(PAPER_WIDTH)
  ) core (
      .clk(clk),
      .rst(rst),
      .reg_write(reg_write),
      .reg_read(reg_read),
      .reg_address(reg_address),
      .reg_write_data(reg_write_data),
      .reg_write_strobe(reg_write_strobe),
      .reg_read_data(reg_read_data),
      .reg_error(reg_error),
      .hold_pin(hold_pin),
      .probe(probe),
      .irq(irq),
      .running(running),
      .step(step),
      .direction(direction),
      .step_strobe(step_strobe),
      .step_backward(step_backward),
      .X_Pwm_Out(X_Pwm_Out),
      .Z_Pwm_Out(Z_Pwm_Out),
      .X_Dir(X_Dir),
      .Z_Dir(Z_Dir)
  );
endmodule
