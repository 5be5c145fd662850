(3: P0000 T001: R -5.000 ist nicht erlaubt, richtig: 0.000..9999.999. Wert ändern.)
P0000
T001 R-5000 L+0
