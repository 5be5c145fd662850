P0001
N001G11F1000
N002G02X+5Y-5I+20000J+0   (nearly full circle, L656)
N003G01X-5Y+5             (closing way)
%
