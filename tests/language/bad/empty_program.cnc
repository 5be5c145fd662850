(2: P0001: Das Programm hat keinen Satz, richtig: N001. Sätze ergänzen oder Nummer streichen.)
P0001
%
