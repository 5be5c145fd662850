(3: P0001 N001: Y 30.000 geht in diesem Zyklus nicht, richtig: Y = 0. Wert ändern.)
P0001
N001 G84 X+40. Y+30. Z-10. Q-4. V002
