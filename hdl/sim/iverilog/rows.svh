// What every bench on rows of vectors has: a clock, the file of +rows=FILE, and an end that tells where.
  logic clk = 1'b0, rst;
  integer rows, got, clocks = 0, in_rst;
  reg [8*256-1:0] name;

  task fail(input integer why);
    begin
      $display("failed at clock %0d: %0d", clocks, why);
      $finish;
    end
  endtask

  task open_rows;
    begin
      if (!$value$plusargs("rows=%s", name)) fail(0);
      rows = $fopen(name, "r");
      if (rows == 0) fail(0);
    end
  endtask

  task pass_clock;
    begin
      clocks = clocks + 1;
      #1 clk = 1'b1;
      #1 clk = 1'b0;
    end
  endtask

  task finish;
    begin
      if (clocks < 1000) fail(9);
      $display("passed %0d clocks", clocks);
      $finish;
    end
  endtask
