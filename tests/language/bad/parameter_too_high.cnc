(3: P0001 N001: X #70 ist nicht erlaubt, richtig: #00..#69. Wert ändern.)
P0001
N001 G01 X#70
