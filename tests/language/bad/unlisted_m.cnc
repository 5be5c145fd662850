(3: P0001 N001: M 06 gibt es nicht. Andere M-Funktion eingeben.)
P0001
N001 G11 M06
