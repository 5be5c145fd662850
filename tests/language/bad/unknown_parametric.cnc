(3: P0001 N001: \18 gibt es an dieser Steuerung nicht. Andere Funktion eingeben.)
P0001
N001\18#01#02
