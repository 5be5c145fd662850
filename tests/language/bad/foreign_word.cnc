(3: P0001 N001: F passt nicht in diesen Satz, richtig: X Y Z. Wort entfernen.)
P0001
N001 G00 X+1 F1000
