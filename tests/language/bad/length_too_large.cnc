(3: P0001 N001: X 10000.000 ist nicht erlaubt, richtig: -9999.999..9999.999. Wert ändern.)
P0001
N001 G00 X+10000000
