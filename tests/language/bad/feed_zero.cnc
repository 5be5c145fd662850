(3: P0001 N001: F 0000 ist nicht erlaubt, richtig: 0001..9999. Wert ändern.)
P0001
N001 G11 F0000
