// leadscrew_fsmc with the pins of a board: the file to synthesise beside an STM32F4. The reset pin may come at any time; it
// ends at a clock, and the registers are reset for as long as it is low and two clocks more.
module leadscrew_fsmc_pins #(
    parameter int AXES = 3,        // 2 … 7
    parameter int WIDTH = 24,      // 4 … 30: of counts, bits: circles of R < 2^(WIDTH−1)
    parameter int FEED_WIDTH = 40, // of the feed DDA's remainder: 33 … 62
    parameter int DEPTH_LOG2 = 4,  // the FIFO holds 2^DEPTH_LOG2 commands
    parameter int PAPER_WIDTH = 0  // 4 … 31: the paper's interpolators too, with coordinates of so many bits
) (
    input logic clk,
    input logic rst_n,

    input  logic        NE,
    input  logic        NOE,
    input  logic        NWE,
    input  logic [ 1:0] NBL,
    input  logic [ 8:1] A,
    inout  wire  [15:0] D,
    output logic        NWAIT,

    input logic hold_pin,  // high: no tick of the feed passes; a button, or the other half of a machine
    input logic probe,     // a touch probe
    output logic irq,      // to the processor, by INTERRUPT_ENABLE
    output logic running,  // a command is being made

    // To the drives
    output logic [AXES-1:0] step,
    output logic [AXES-1:0] direction,  // 1: backward
    // Of the paper's interpolator that is selected; low where there is none
    output logic X_Pwm_Out,
    output logic Z_Pwm_Out,
    output logic X_Dir,
    output logic Z_Dir
);
  logic [1:0] reset = 2'b11;
  always_ff @(posedge clk) reset <= {reset[0], !rst_n};

  logic [15:0] D_out;
  logic D_drive;
  assign D = D_drive ? D_out : 16'hzzzz;

  // Inputs that are not synchronous to clk
  logic [1:0] hold_seen;
  always_ff @(posedge clk) hold_seen <= {hold_seen[0], hold_pin};

  logic [AXES-1:0] step_strobe, step_backward;
  logic unused;
  assign unused = &{1'b0, step_strobe, step_backward};

  leadscrew_fsmc #(
      .AXES(AXES),
      .WIDTH(WIDTH),
      .FEED_WIDTH(FEED_WIDTH),
      .DEPTH_LOG2(DEPTH_LOG2),
      .PAPER_WIDTH(PAPER_WIDTH)
  ) leadscrew (
      .clk(clk),
      .rst(reset[1]),
      .D_in(D),
      .hold_pin(hold_seen[1]),
      .NE(NE),
      .NOE(NOE),
      .NWE(NWE),
      .NBL(NBL),
      .A(A),
      .D_out(D_out),
      .D_drive(D_drive),
      .NWAIT(NWAIT),
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
