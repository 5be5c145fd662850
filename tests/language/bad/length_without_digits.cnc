(3: P0001 N001: X ist kein Wort der Steuerung. Text berichtigen.)
P0001
N001 G00 X+ Y+1
