(3: P0001 N001: E passt nicht in diesen Satz, richtig: X Y Z F S T M. Wort entfernen.)
P0001
N001 G01 X+1 E045
