// The motion core on Wishbone B4: beside a processor on the same chip.
module leadscrew_wishbone #(
    parameter int AXES = 3,        // 2 … 7
    parameter int WIDTH = 24,      // 4 … 30: of counts, bits: circles of R < 2^(WIDTH−1)
    parameter int FEED_WIDTH = 40, // of the feed DDA's remainder: 33 … 62
    parameter int DEPTH_LOG2 = 4,  // the FIFO holds 2^DEPTH_LOG2 commands
    parameter int PAPER_WIDTH = 0  // 4 … 31: the paper's interpolators too, with coordinates of so many bits
) (
    input logic clk,
    input logic rst,  // synchronous

    input  logic        cyc_i,  // as bus/wishbone.sv has them
    input  logic        stb_i,
    input  logic        we_i,
    input  logic [ 8:2] adr_i,
    input  logic [31:0] dat_i,
    input  logic [ 3:0] sel_i,
    output logic [31:0] dat_o,
    output logic        ack_o,
    output logic        err_o,
    output logic        stall_o,

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

  wishbone bus (
      .clk(clk),
      .rst(rst),
      .cyc_i(cyc_i),
      .stb_i(stb_i),
      .we_i(we_i),
      .adr_i(adr_i),
      .dat_i(dat_i),
      .sel_i(sel_i),
      .dat_o(dat_o),
      .ack_o(ack_o),
      .err_o(err_o),
      .stall_o(stall_o),
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
