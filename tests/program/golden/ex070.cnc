P0001
N001 G00 X+5000
N002 G69 X-1000   (to the negative switch)
N003 G68 X+0      (which is zero)
N004 G90
N005 G00 X+2000
N006 G01 Y+1000 F0500
%
