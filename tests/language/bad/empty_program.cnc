(2: P0001: Das Programm: Übertragung falsch, richtig: N001. Daten prüfen, neu senden.)
P0001
%
