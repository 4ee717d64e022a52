// The motion core on the memory bus of a microcontroller (FSMC, asynchronous SRAM of 16 bits). D is in two halves here, for
// simulators; leadscrew_fsmc_pins.sv has the pins of a board.
module leadscrew_fsmc #(
    parameter int AXES = 3,        // 2 … 7
    parameter int WIDTH = 24,      // 4 … 30: of counts, bits: circles of R < 2^(WIDTH−1)
    parameter int FEED_WIDTH = 40, // of the feed DDA's remainder: 33 … 62
    parameter int DEPTH_LOG2 = 4,  // the FIFO holds 2^DEPTH_LOG2 commands
    parameter int PAPER_WIDTH = 0  // 4 … 31: the paper's interpolators too, with coordinates of so many bits
) (
    input logic clk,
    input logic rst,  // synchronous

    input  logic        NE,       // as bus/fsmc.sv has them
    input  logic        NOE,
    input  logic        NWE,
    input  logic [ 1:0] NBL,
    input  logic [ 8:1] A,
    input  logic [15:0] D_in,
    output logic [15:0] D_out,
    output logic        D_drive,
    output logic        NWAIT,

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

  fsmc bus (
      .clk(clk),
      .rst(rst),
      .NE(NE),
      .NOE(NOE),
      .NWE(NWE),
      .NBL(NBL),
      .A(A),
      .D_in(D_in),
      .D_out(D_out),
      .D_drive(D_drive),
      .NWAIT(NWAIT),
      .reg_write(reg_write),
      .reg_read(reg_read),
      .reg_address(reg_address),
      .reg_write_data(reg_write_data),
      .reg_write_strobe(reg_write_strobe),
      .reg_read_data(reg_read_data)
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

  // The bus cannot tell an error: it stands in the register ERROR.
  logic unused;
  assign unused = &{1'b0, reg_error};
endmodule
