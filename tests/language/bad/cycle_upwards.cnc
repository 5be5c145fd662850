(3: P0001 N001: Z 10.000 geht in diesem Zyklus nicht, richtig: Z < 0. Wert ändern.)
P0001
N001 G81 Z+10000 V002 H0000
