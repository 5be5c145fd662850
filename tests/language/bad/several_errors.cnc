(5: P0001 N001: G77 gibt es an dieser Steuerung nicht. Andere Funktion eingeben.)
(7: P0001 N003: S 0000 ist nicht erlaubt, richtig: 0001..9999. Wert ändern.)
(9: P0003 N001: R fehlt. Wort ergänzen.)
P0001
N001 G77 X+1
N002 G17
N003 G11 S0000
P0003
N001 G10
