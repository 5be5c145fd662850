(3: P0001 N001: * ist kein Wort der Steuerung. Text berichtigen.)
P0001
N001 G01 X+1 * M03
