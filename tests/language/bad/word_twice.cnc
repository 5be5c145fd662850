(3: P0001 N001: X 2× passt nicht in diesen Satz. Wort entfernen.)
P0001
N001 G01 X+1 X+2
