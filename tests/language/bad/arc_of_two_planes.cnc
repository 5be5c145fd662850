(3: P0001 N001: K passt nicht in diesen Satz, richtig: X Y I J. Wort entfernen.)
P0001
N001 G02 X+1 Y+2 I+3 K+4
