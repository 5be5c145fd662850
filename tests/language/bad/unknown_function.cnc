(3: P0001 N002: G99 gibt es an dieser Steuerung nicht. Andere Funktion eingeben.)
P0001 N001 G17
N002 G99 X+1
